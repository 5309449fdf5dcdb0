package org.dfra.river.access;

import java.net.InetAddress;
import java.net.UnknownHostException;
import org.jspecify.annotations.Nullable;

/** Reads IP addresses that are written in digits, and never asks a name service. */
public final class NumericAddress {

  private NumericAddress() {}

  /**
   * Reads an IPv4 or IPv6 address without scope.
   *
   * @return null if the text is none, for example a host name
   */
  public static @Nullable InetAddress parse(String text) {
    boolean isNumeric =
        text.matches("[0-9]{1,3}(\\.[0-9]{1,3}){3}")
            || (text.indexOf(':') >= 0 && text.matches("[0-9A-Fa-f:][0-9A-Fa-f:.]*"));
    if (!isNumeric) {
      return null;
    }
    try {
      return InetAddress.getByName(text);
    } catch (UnknownHostException e) { // digits, but out of range
      return null;
    }
  }
}
