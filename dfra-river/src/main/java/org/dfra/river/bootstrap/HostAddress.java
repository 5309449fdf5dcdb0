package org.dfra.river.bootstrap;

import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.util.Comparator;
import java.util.Optional;
import java.util.regex.Pattern;
import org.dfra.core.config.ConfigurationException;

/** The address of this host that its proxies carry. */
public final class HostAddress {

  /** Has an interface chosen automatically. */
  public static final String AUTO = "auto";

  private static final Pattern VERSION_4 =
      Pattern.compile("(?:(?:25[0-5]|2[0-4]\\d|1\\d\\d|[1-9]?\\d)(?:\\.(?!$)|$)){4}");

  private HostAddress() {}

  /**
   * The address to put into proxies.
   *
   * @param configured an address or name, or {@link #AUTO}: the first IPv4 address of an interface
   *     that is up, physical and not the loopback; the loopback if there is no other
   * @throws ConfigurationException if the name is unknown, is not an address of this host, or is
   *     not the loopback's name but resolves to the loopback here
   */
  public static String resolve(String configured) {
    return configured.equals(AUTO) ? choose() : check(configured);
  }

  /**
   * As {@link #resolve}, but without a name service, which may take long to answer: a name is
   * returned unchecked.
   *
   * @throws ConfigurationException if an address is not one of this host
   */
  public static String resolveWithoutLookup(String configured) {
    return isName(configured) ? configured : resolve(configured);
  }

  /**
   * Whether resolving the text needs a name service: it is neither an address nor {@link #AUTO}.
   */
  public static boolean isName(String configured) {
    return !configured.equals(AUTO) && literal(configured).isEmpty();
  }

  /**
   * Parses a numeric address, such as {@code 192.0.2.7} or {@code 2001:db8::7}; empty for
   * everything else. No name service is used.
   */
  public static Optional<InetAddress> literal(String text) {
    boolean isVersion6 = text.indexOf(':') >= 0;
    if (!isVersion6 && !VERSION_4.matcher(text).matches()) {
      return Optional.empty();
    }
    try { // in brackets only an IPv6 address is accepted
      return Optional.of(InetAddress.getByName(isVersion6 ? "[" + text + "]" : text));
    } catch (UnknownHostException e) {
      return Optional.empty();
    }
  }

  /** Whether a resolved host can be reached from this machine only. */
  public static boolean isLoopback(String host) {
    try {
      return InetAddress.getByName(host).isLoopbackAddress();
    } catch (UnknownHostException e) {
      return false;
    }
  }

  private static String choose() {
    try {
      Optional<String> found =
          NetworkInterface.networkInterfaces()
              .filter(HostAddress::isUsable)
              .sorted(Comparator.comparingInt(NetworkInterface::getIndex))
              .flatMap(NetworkInterface::inetAddresses)
              .filter(address -> address.getAddress().length == 4)
              .filter(address -> !address.isLoopbackAddress() && !address.isLinkLocalAddress())
              .map(InetAddress::getHostAddress)
              .findFirst();
      return found.orElse("127.0.0.1");
    } catch (SocketException e) {
      throw new ConfigurationException(
          "the network interfaces of this host cannot be listed; name its address with host=\"…\"",
          e);
    }
  }

  private static boolean isUsable(NetworkInterface candidate) {
    try {
      return candidate.isUp() && !candidate.isLoopback() && !candidate.isVirtual();
    } catch (SocketException e) {
      return false; // the interface was removed
    }
  }

  private static String check(String wanted) {
    try {
      InetAddress address = InetAddress.getByName(wanted);
      if (!address.isLoopbackAddress() && NetworkInterface.getByInetAddress(address) == null) {
        throw new ConfigurationException(
            "host "
                + wanted
                + " is "
                + (wanted.equals(address.getHostAddress())
                    ? ""
                    : address.getHostAddress() + ", which is ")
                + "not an address of this machine; name one of its addresses, or auto");
      }
      if (address.isLoopbackAddress() && !saysLoopback(wanted)) {
        // Debian maps every machine's own name to 127.0.1.1 in /etc/hosts.
        throw new ConfigurationException(
            "host "
                + wanted
                + " is "
                + address.getHostAddress()
                + " here, which no other machine reaches; name an address of an interface, or auto,"
                + " or localhost where only this machine is meant");
      }
      return wanted;
    } catch (UnknownHostException | SocketException e) {
      throw new ConfigurationException(
          "host " + wanted + " is not known; name an address of this machine, or auto", e);
    }
  }

  /** Whether it is an address, or the usual name of the loopback. */
  private static boolean saysLoopback(String wanted) {
    return wanted.equalsIgnoreCase("localhost")
        || wanted.indexOf(':') >= 0
        || wanted.chars().allMatch(c -> c == '.' || Character.isDigit(c));
  }
}
