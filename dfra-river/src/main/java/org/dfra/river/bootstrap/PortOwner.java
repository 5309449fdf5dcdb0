package org.dfra.river.bootstrap;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Stream;

/**
 * Finds the user that listens on a TCP port of this computer, from Linux's {@code /proc/net/tcp}.
 * On other systems the owner is unknown.
 *
 * <p>An unprivileged user can listen on phoenix's port while phoenix does not run. Phoenix's secret
 * identity must not be sent there.
 */
final class PortOwner {

  private static final String LISTEN = "0A"; // proc_net_tcp(5)
  private static final int LOCAL = 1;
  private static final int STATE = 3;
  private static final int UID = 7;
  private static final int WORD = 4;

  private final Path proc;
  private final Path users;

  /**
   * @param proc the folder {@code /proc}
   * @param users the file {@code /etc/passwd}
   */
  PortOwner(Path proc, Path users) {
    this.proc = proc;
    this.users = users;
  }

  /** The owners of this computer's ports. */
  static PortOwner system() {
    return new PortOwner(Path.of("/proc"), Path.of("/etc/passwd"));
  }

  /**
   * The UID of the process that listens there; empty if there is none, or if it is unknown.
   *
   * @param host address or name of this computer
   */
  OptionalInt uidOf(String host, int port) {
    InetAddress[] wanted;
    try {
      wanted = InetAddress.getAllByName(host);
    } catch (UnknownHostException e) {
      return OptionalInt.empty(); // no connection to it is possible
    }
    List<InetAddress> addresses = List.of(wanted);
    return Stream.of("net/tcp", "net/tcp6")
        .flatMap(table -> lines(proc.resolve(table)))
        .map(line -> line.strip().split("\\s+"))
        .filter(fields -> fields.length > UID && fields[STATE].equals(LISTEN))
        .filter(fields -> isAt(fields[LOCAL], addresses, port))
        .mapToInt(fields -> Integer.parseInt(fields[UID]))
        .findFirst();
  }

  private static Stream<String> lines(Path table) {
    try {
      return Files.readAllLines(table, StandardCharsets.US_ASCII).stream().skip(1); // headings
    } catch (IOException e) {
      return Stream.of(); // a computer without IPv6 has one table, and one without Linux has none
    }
  }

  /** Whether a socket at this local address, in the table's notation, accepts such a connection. */
  private static boolean isAt(String local, List<InetAddress> addresses, int port) {
    int colon = local.lastIndexOf(':');
    if (Integer.parseInt(local.substring(colon + 1), 16) != port) {
      return false;
    }
    try {
      InetAddress address = InetAddress.getByAddress(bytes(local.substring(0, colon)));
      return address.isAnyLocalAddress() || addresses.contains(address);
    } catch (UnknownHostException e) {
      throw new IllegalStateException("4 or 16 bytes are an address, and not " + local, e);
    }
  }

  /** An address is written as words of four bytes, the least significant byte last. */
  private static byte[] bytes(String hexadecimal) {
    byte[] written = HexFormat.of().parseHex(hexadecimal);
    byte[] address = new byte[written.length];
    for (int i = 0; i < written.length; i++) {
      int inWord = i % WORD;
      address[i] = written[i - inWord + WORD - 1 - inWord];
    }
    return address;
  }

  /** The name of a user, or else its number. */
  String userName(int uid) {
    String number = Integer.toString(uid);
    try {
      return Files.readAllLines(users, StandardCharsets.UTF_8).stream()
          .map(line -> line.split(":", -1))
          .filter(fields -> fields.length > 2 && fields[2].equals(number))
          .map(fields -> fields[0])
          .findFirst()
          .orElse(number);
    } catch (IOException e) {
      return number; // no such file here
    }
  }
}
