package org.dfra.drivers.camera.mjpeg;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What stands before a body: of a response, or of a part of one.
 *
 * @param status as in {@code 404}; 0 where it is a part's
 * @param reason as in {@code Not Found}; may be empty
 * @param headers values by names in lower case; of a name given twice the first
 */
public record HttpHead(int status, String reason, Map<String, String> headers) {

  private static final Pattern STATUS = Pattern.compile("HTTP/1\\.[01] ([1-5][0-9]{2})(?: (.*))?");
  private static final Pattern BOUNDARY =
      Pattern.compile("(?i).*;\\s*boundary\\s*=\\s*(?:\"([^\"]+)\"|([^\\s;]+)).*");
  private static final int LONGEST_BOUNDARY = 100; // RFC 2046 says 70

  public HttpHead {
    headers = Map.copyOf(headers);
  }

  /** Reads a response's; empty where its first line is no status line. */
  static Optional<HttpHead> ofResponse(byte[] bytes, int offset, int length) {
    String[] lines = lines(bytes, offset, length);
    Matcher matcher = STATUS.matcher(lines[0].stripTrailing());
    if (!matcher.matches()) {
      return Optional.empty();
    }
    String reason = matcher.group(2) == null ? "" : printable(matcher.group(2));
    return Optional.of(new HttpHead(Integer.parseInt(matcher.group(1)), reason, headers(lines, 1)));
  }

  /** Reads a part's, which may be empty. */
  static HttpHead ofPart(byte[] bytes, int offset, int length) {
    return new HttpHead(0, "", headers(lines(bytes, offset, length), 0));
  }

  private static String[] lines(byte[] bytes, int offset, int length) {
    return new String(bytes, offset, length, StandardCharsets.ISO_8859_1).split("\r?\n", -1);
  }

  private static Map<String, String> headers(String[] lines, int from) {
    Map<String, String> headers = new TreeMap<>();
    for (int i = from; i < lines.length; i++) {
      int colon = lines[i].indexOf(':');
      if (colon > 0) {
        headers.putIfAbsent(
            lines[i].substring(0, colon).strip().toLowerCase(Locale.ROOT),
            printable(lines[i].substring(colon + 1).strip()));
      }
    }
    return headers;
  }

  /** Without what could spoil a log; a stranger has written it. */
  private static String printable(String text) {
    String clean = text.replaceAll("[^\\x20-\\x7E]", "?");
    return clean.length() > 200 ? clean.substring(0, 200) + "…" : clean;
  }

  /** The value of a header, by its name in lower case; empty where there is none. */
  public String header(String name) {
    return headers.getOrDefault(name, "");
  }

  /** The media type without its parameters, in lower case; empty where none is told. */
  public String mediaType() {
    String type = header("content-type");
    int end = type.indexOf(';');
    return (end < 0 ? type : type.substring(0, end)).strip().toLowerCase(Locale.ROOT);
  }

  /**
   * What separates the parts, without leading hyphens, since some cameras count these as part of it
   * and some do not; empty where this is no head of a multipart body.
   */
  public String boundary() {
    Matcher matcher = BOUNDARY.matcher(header("content-type"));
    if (!mediaType().startsWith("multipart/") || !matcher.matches()) {
      return "";
    }
    String reported = matcher.group(1) == null ? matcher.group(2) : matcher.group(1);
    String core = reported.replaceFirst("^-+", "");
    return core.length() > LONGEST_BOUNDARY ? "" : core;
  }
}
