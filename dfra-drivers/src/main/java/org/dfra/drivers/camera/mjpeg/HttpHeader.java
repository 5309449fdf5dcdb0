package org.dfra.drivers.camera.mjpeg;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The head of an HTTP response, or of a part of a multipart body.
 *
 * @param status such as {@code 404}; 0 for the head of a part
 * @param reason such as {@code Not Found}; may be empty
 * @param headers values by lower-case name; the first value of a repeated name
 */
record HttpHeader(int status, String reason, Map<String, String> headers) {

  private static final Pattern STATUS = Pattern.compile("HTTP/1\\.[01] ([1-5][0-9]{2})(?: (.*))?");
  private static final Pattern BOUNDARY =
      Pattern.compile("(?i).*;\\s*boundary\\s*=\\s*(?:\"([^\"]+)\"|([^\\s;]+)).*");
  private static final int LONGEST_BOUNDARY = 100; // maximum 70, RFC 2046

  public HttpHeader {
    headers = Map.copyOf(headers);
  }

  /** Parses a response's head; empty where its first line is not a status line. */
  static Optional<HttpHeader> ofResponse(byte[] bytes, int offset, int length) {
    String[] lines = lines(bytes, offset, length);
    Matcher matcher = STATUS.matcher(lines[0].stripTrailing());
    if (!matcher.matches()) {
      return Optional.empty();
    }
    String reason = matcher.group(2) == null ? "" : printable(matcher.group(2));
    return Optional.of(
        new HttpHeader(Integer.parseInt(matcher.group(1)), reason, headers(lines, 1)));
  }

  /** Parses the head of a part, which may be empty. */
  static HttpHeader ofPart(byte[] bytes, int offset, int length) {
    return new HttpHeader(0, "", headers(lines(bytes, offset, length), 0));
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

  /** Removes characters that could corrupt a log; the text comes from the network. */
  private static String printable(String text) {
    String clean = text.replaceAll("[^\\x20-\\x7E]", "?");
    return clean.length() > 200 ? clean.substring(0, 200) + "…" : clean;
  }

  /** The value of a header, by its name in lower case; empty where there is none. */
  public String header(String name) {
    return headers.getOrDefault(name, "");
  }

  /** The media type without its parameters, in lower case; empty where the head has none. */
  public String mediaType() {
    String type = header("content-type");
    int end = type.indexOf(';');
    return (end < 0 ? type : type.substring(0, end)).strip().toLowerCase(Locale.ROOT);
  }

  /**
   * The boundary between parts, without leading hyphens, because cameras differ in whether they
   * belong to it; empty where this is not the head of a multipart body.
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
