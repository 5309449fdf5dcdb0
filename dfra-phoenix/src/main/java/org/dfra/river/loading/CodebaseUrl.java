package org.dfra.river.loading;

import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.StringTokenizer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * One URL of a codebase: {@code httpmd://host:port/path.jar;sha-256=digest}, as in River's {@code
 * net.jini.url.httpmd}, no other form.
 *
 * @param text the URL as it was written
 * @param location HTTP address of the jar
 * @param digest the SHA-256 of the jar, 64 hexadecimal digits in lower case
 */
record CodebaseUrl(String text, URI location, String digest) {

  private static final Pattern HTTPMD =
      Pattern.compile(
          "httpmd://(?<place>[^/?#;@\\s]+(/[^/?#;\\s]+)+);(?<algorithm>[^=;,\\s]+)="
              + "(?<digest>[0-9a-fA-F]+)(,[^\\s/?#]*)?");

  /**
   * Parses the URLs of a codebase annotation, which are separated by spaces.
   *
   * @throws CodeRefusedException if there is none, or one of another form
   */
  static List<CodebaseUrl> parse(String codebase) {
    List<CodebaseUrl> urls = new ArrayList<>();
    StringTokenizer tokens = new StringTokenizer(codebase);
    while (tokens.hasMoreTokens()) {
      urls.add(one(tokens.nextToken()));
    }
    if (urls.isEmpty()) {
      throw new CodeRefusedException("the codebase has no URL; name one to load code from");
    }
    return List.copyOf(urls);
  }

  private static CodebaseUrl one(String text) {
    Matcher form = HTTPMD.matcher(text);
    if (!form.matches()) {
      throw new CodeRefusedException(
          "codebase "
              + text
              + " refused: "
              + fault(text)
              + "; "
              + "serve the jar with a class server");
    }
    String algorithm = form.group("algorithm");
    String digest = form.group("digest").toLowerCase(Locale.ROOT);
    if (!algorithm.toLowerCase(Locale.ROOT).equals("sha-256") || digest.length() != 64) {
      throw new CodeRefusedException(
          "codebase "
              + text
              + " refused: its digest is "
              + algorithm
              + " with "
              + digest.length()
              + " digits, but must be sha-256 with 64; serve the jar with a class server");
    }
    try {
      return new CodebaseUrl(text, URI.create("http://" + form.group("place")), digest);
    } catch (IllegalArgumentException e) {
      throw new CodeRefusedException(
          "codebase " + text + " refused: it is not a URL; correct it", e);
    }
  }

  private static String fault(String text) {
    @Nullable String scheme =
        text.matches("[A-Za-z][A-Za-z0-9+.-]*:.*")
            ? text.substring(0, text.indexOf(':') + 1).toLowerCase(Locale.ROOT)
            : null;
    if (scheme == null) {
      return "it is not a URL";
    }
    return scheme.equals("httpmd:")
        ? "it is not of the form httpmd://host:port/name.jar;sha-256=digest"
        : scheme + " is not accepted, only httpmd: with a sha-256 digest";
  }
}
