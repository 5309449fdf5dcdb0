package org.dfra.drivers.link;

import java.io.IOException;
import java.util.Set;

/**
 * A serial server or an emulator on the network: {@code tcp://host:port}; an IPv6 address in
 * brackets.
 *
 * @param url the URL as configured
 * @param host host name or address
 * @param port TCP port, 1 to 65535
 */
public record TcpAddress(String url, String host, int port) implements LinkAddress {

  private static final String FORM = "write tcp://host:port, the port from 1 to 65535";

  static TcpAddress of(LinkUrl parts) {
    parts.allow(Set.of());
    if (!parts.target().startsWith("//")) {
      throw parts.fault("two slashes are missing; " + FORM);
    }
    String target = parts.target().substring(2);
    int colon = target.lastIndexOf(':');
    if (colon < 0 || target.endsWith("]")) {
      throw parts.fault("it names no port; " + FORM);
    }
    String host = target.substring(0, colon);
    if (host.startsWith("[") && host.endsWith("]")) {
      host = host.substring(1, host.length() - 1);
    }
    if (host.isBlank()) {
      throw parts.fault("it names no host; " + FORM);
    }
    return new TcpAddress(parts.url(), host, portOf(parts, target.substring(colon + 1)));
  }

  private static int portOf(LinkUrl parts, String text) {
    int port;
    try {
      port = Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw parts.fault("the port is \"" + text + "\", which is not a number; " + FORM);
    }
    if (port < 1 || port > 65535) {
      throw parts.fault("the port is " + port + "; " + FORM);
    }
    return port;
  }

  @Override
  public SerialLink open(Ticker ticker) throws IOException {
    return TcpLink.open(this);
  }

  @Override
  public String toString() {
    return url;
  }
}
