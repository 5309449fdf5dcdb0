package org.dfra.drivers.link;

import java.io.IOException;
import org.dfra.drivers.link.SimLinkRegistry.SimAddress;

/**
 * The address of a device: a parsed and checked link URL. {@code toString} is the URL as
 * configured.
 */
public sealed interface LinkAddress permits SerialAddress, TcpAddress, ReplayAddress, SimAddress {

  /**
   * Parses a URL: {@code serial:}, {@code tcp:}, {@code replay:} or {@code sim:}.
   *
   * @throws IllegalArgumentException if it is invalid; the message explains what is wrong and what
   *     is allowed
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
   * Parses a URL and opens the link, in real time.
   *
   * @throws IllegalArgumentException if it is not a link URL
   * @throws IOException if the link cannot be opened
   */
  static SerialLink open(String url) throws IOException {
    return parse(url).open(Ticker.system());
  }

  /**
   * Opens the link. Bytes received before this call are discarded where the link can detect them.
   *
   * @param ticker the clock of a link that paces its bytes, and the owner of the {@code sim:} links
   * @throws IOException if it cannot be opened; the message explains why and what to check
   */
  SerialLink open(Ticker ticker) throws IOException;
}
