package org.dfra.core.config;

import java.net.InetAddress;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.UnknownHostException;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Validation rules for single texts of a description. Each rule returns an error message, or null.
 * The reader collects the messages of a whole file; a record's constructor throws the first one.
 */
public final class DescriptionRules {

  private static final Pattern SNAKE = Pattern.compile("[a-z][a-z0-9]*(_[a-z0-9]+)*");
  private static final Pattern CLASS =
      Pattern.compile(
          "(\\p{javaJavaIdentifierStart}\\p{javaJavaIdentifierPart}*\\.)*"
              + "\\p{javaJavaIdentifierStart}\\p{javaJavaIdentifierPart}*");
  private static final Pattern IPV4 =
      Pattern.compile("(25[0-5]|2[0-4]\\d|1?\\d?\\d)(\\.(25[0-5]|2[0-4]\\d|1?\\d?\\d)){3}");

  private static final Pattern IPV6_CHARACTERS = Pattern.compile("[0-9A-Fa-f:][0-9A-Fa-f:.]*");

  /** As RFC 1123 has it, except names of digits and dots only, which are taken as addresses. */
  private static final Pattern HOST_NAME =
      Pattern.compile(
          "(?![0-9.]+$)[A-Za-z0-9]([A-Za-z0-9-]*[A-Za-z0-9])?"
              + "(\\.[A-Za-z0-9]([A-Za-z0-9-]*[A-Za-z0-9])?)*");

  private static final int LAST_PORT = 65535;

  private DescriptionRules() {}

  /** Throws the error message, if there is one, with its place. */
  public static void require(SourceLocation place, @Nullable String complaint) {
    if (complaint != null) {
      throw new ConfigurationException(place + ": " + complaint);
    }
  }

  /**
   * @param what the kind of the named object, such as {@code robot}
   */
  public static @Nullable String name(String what, String name) {
    if (SNAKE.matcher(name).matches()) {
      return null;
    }
    String snake =
        name.trim()
            .replaceAll("(?<=[a-z0-9])(?=[A-Z])", "_")
            .replaceAll("[^A-Za-z0-9]+", "_")
            .toLowerCase(Locale.ROOT);
    return "the "
        + what
        + " name \""
        + name
        + "\" is not lower_snake_case; write "
        + (SNAKE.matcher(snake).matches()
            ? "\"" + snake + "\""
            : "lower-case letters, digits and single underscores, beginning with a letter");
  }

  /**
   * @param label the owner of the class: {@code module} and its name
   */
  static @Nullable String className(String label, String key, String name) {
    return CLASS.matcher(name).matches()
        ? null
        : "the "
            + key
            + " of "
            + label
            + " is \""
            + name
            + "\", which is not a class name; write the full name of a Java class";
  }

  static @Nullable String host(String host) {
    return host.isEmpty() || host.chars().anyMatch(Character::isWhitespace)
        ? "the host is \"" + host + "\"; write one address or host name, or auto"
        : null;
  }

  static @Nullable String lookupGroup(String group) {
    return group.isBlank() || group.contains(",") || !group.equals(group.strip())
        ? "the discovery group \"" + group + "\" is blank or holds a comma; write one name"
        : null;
  }

  /** An address, a range of addresses, or a host name. */
  static @Nullable String administrator(String text) {
    return addresses("the administrator's address", text);
  }

  /** An address, a range of addresses, or a host name. */
  static @Nullable String moduleHost(String text) {
    return addresses("the registrar's module host", text);
  }

  private static @Nullable String addresses(String what, String text) {
    int slash = text.indexOf('/');
    String address = slash < 0 ? text : text.substring(0, slash);
    int bits = bits(address);
    boolean isRight =
        slash < 0
            ? bits > 0 || HOST_NAME.matcher(text).matches()
            : bits > 0 && isPrefix(text.substring(slash + 1), bits);
    return isRight
        ? null
        : what
            + " \""
            + text
            + "\" is not understood; write an address, a range such as 10.0.0.0/24, or a host name";
  }

  /** The number of bits of a numeric address; 0 if it is not one. Nothing is resolved. */
  private static int bits(String address) {
    boolean isIpv6 = address.indexOf(':') >= 0 && IPV6_CHARACTERS.matcher(address).matches();
    if (!isIpv6 && !IPV4.matcher(address).matches()) {
      return 0;
    }
    try {
      return InetAddress.getByName(address).getAddress().length * Byte.SIZE;
    } catch (UnknownHostException e) { // colons alone are not an IPv6 address
      return 0;
    }
  }

  private static boolean isPrefix(String text, int bits) {
    return text.matches("[0-9]{1,3}") && Integer.parseInt(text) <= bits;
  }

  static @Nullable String registrarPort(String port) {
    return number(port) >= 0
        ? null
        : "the registrar's port is \"" + port + "\"; write a whole number from 0 to " + LAST_PORT;
  }

  /** A class server's port has to stay the same, so the system must not choose it. */
  static @Nullable String classServerPort(String port) {
    return number(port) > 0
        ? null
        : "the class server's port is \""
            + port
            + "\"; write a whole number from 1 to "
            + LAST_PORT
            + ", or off";
  }

  static @Nullable String locator(String text) {
    return canonicalLocator(text).isPresent()
        ? null
        : "the locator \""
            + text
            + "\" is not understood; write host, host:port or jini://host:port, the port from 1 to "
            + LAST_PORT;
  }

  /** The locator as {@code jini://host} or {@code jini://host:port}; empty if it is not one. */
  static Optional<String> canonicalLocator(String text) {
    try {
      URI uri = new URI(text.startsWith("jini://") ? text : "jini://" + text);
      boolean plain =
          uri.getHost() != null
              && uri.getUserInfo() == null
              && (uri.getPath().isEmpty() || uri.getPath().equals("/"))
              && uri.getQuery() == null
              && uri.getFragment() == null;
      if (!plain || uri.getPort() == 0 || uri.getPort() > LAST_PORT) {
        return Optional.empty();
      }
      String port = uri.getPort() < 0 ? "" : ":" + uri.getPort();
      return Optional.of("jini://" + uri.getHost() + port);
    } catch (URISyntaxException e) {
      return Optional.empty();
    }
  }

  /** The port, or −1 if the text is not one. */
  private static int number(String port) {
    return port.matches("[0-9]{1,5}") && Integer.parseInt(port) <= LAST_PORT
        ? Integer.parseInt(port)
        : -1;
  }
}
