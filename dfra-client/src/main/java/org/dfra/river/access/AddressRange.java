package org.dfra.river.access;

import java.net.InetAddress;
import org.jspecify.annotations.Nullable;

/**
 * Internet addresses with the same leading bits. Host names are not resolved here.
 *
 * @param network an address of the range; the bits behind the prefix are ignored
 * @param prefix number of equal leading bits: 0 to 32 of an IPv4 address, 0 to 128 of an IPv6
 *     address
 */
public record AddressRange(InetAddress network, int prefix) {

  public AddressRange {
    int bits = network.getAddress().length * Byte.SIZE;
    if (prefix < 0 || prefix > bits) {
      throw new IllegalArgumentException(
          "the prefix of "
              + network.getHostAddress()
              + "/"
              + prefix
              + " is outside 0 to "
              + bits
              + "; write the number of bits that are the same in all its addresses");
    }
  }

  /** One address. */
  public static AddressRange only(InetAddress address) {
    return new AddressRange(address, address.getAddress().length * Byte.SIZE);
  }

  /**
   * Parses an address, or a range such as {@code 10.0.0.0/24} or {@code fd00::/8}.
   *
   * @throws IllegalArgumentException if the text is neither; nothing is resolved
   */
  public static AddressRange of(String text) {
    int slash = text.indexOf('/');
    InetAddress address = numeric(slash < 0 ? text : text.substring(0, slash), text);
    if (slash < 0) {
      return only(address);
    }
    String prefix = text.substring(slash + 1);
    if (!prefix.matches("[0-9]{1,3}")) {
      throw fault(text);
    }
    return new AddressRange(address, Integer.parseInt(prefix));
  }

  private static InetAddress numeric(String address, String whole) {
    @Nullable InetAddress numeric = NumericAddress.parse(address);
    if (numeric == null) {
      throw fault(whole);
    }
    return numeric;
  }

  private static IllegalArgumentException fault(String text) {
    return new IllegalArgumentException(
        "\""
            + text
            + "\" is neither an address nor a range; write 10.0.0.7, 10.0.0.0/24 or fd00::/8");
  }

  /** Whether an address is in the range; one of the other IP version never is. */
  public boolean contains(InetAddress address) {
    byte[] own = network.getAddress();
    byte[] other = address.getAddress();
    if (own.length != other.length) {
      return false;
    }
    int whole = prefix / Byte.SIZE;
    for (int i = 0; i < whole; i++) {
      if (own[i] != other[i]) {
        return false;
      }
    }
    int rest = prefix % Byte.SIZE;
    return rest == 0 || (own[whole] ^ other[whole]) >> (Byte.SIZE - rest) == 0;
  }

  /** In the form that {@link #of} parses. */
  @Override
  public String toString() {
    return network.getHostAddress() + "/" + prefix;
  }
}
