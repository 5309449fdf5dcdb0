package org.dfra.drivers.link;

import java.io.IOException;

/** Where a device is: a link's URL, read and checked. {@code toString} is the URL as written. */
public sealed interface LinkAddress permits SerialAddress, TcpAddress, ReplayAddress, SimAddress {

  /**
   * Reads a URL: {@code serial:}, {@code tcp:}, {@code replay:} or {@code sim:}.
   *
   * @throws IllegalArgumentException if it is not one; the message says what is wrong and what is
   *     allowed
   */
  static LinkAddress parse(String url) {
    LinkUrl parts = LinkUrl.split(url);
    return switch (parts.scheme()) {
      case "serial" -> SerialAddress.of(parts);
      case "tcp" -> TcpAddress.of(parts);
      case "replay" -> ReplayAddress.of(parts);
      case "sim" -> SimAddress.of(parts);
      default ->
          throw parts.fault("the scheme \"" + parts.scheme() + "\" is unknown; " + LinkUrl.ALLOWED);
    };
  }

  /**
   * Reads a URL and opens the link, on real time.
   *
   * @throws IllegalArgumentException if it is no link's URL
   * @throws IOException if the link cannot be opened
   */
  static SerialLink open(String url) throws IOException {
    return parse(url).open(Ticker.system());
  }

  /**
   * Opens the link. Bytes that came before this call are thrown away where the link can tell.
   *
   * @param ticker the time to wait by, where the link itself paces its bytes; and whose {@code
   *     sim:} links are meant
   * @throws IOException if it cannot be opened; the message says why and what to look at
   */
  SerialLink open(Ticker ticker) throws IOException;
}
