package org.dfra.river.bootstrap;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import org.dfra.core.host.ListeningSocket;

/**
 * Finds the user that listens on a TCP port of this computer, from Linux's {@code /proc/net/tcp}.
 * On other systems the owner is unknown.
 *
 * <p>An unprivileged user can listen on phoenix's port while phoenix does not run. Phoenix's secret
 * identity must not be sent there.
 */
final class PortOwner {

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
    return ListeningSocket.all(proc).stream()
        .filter(socket -> socket.port() == port)
        .filter(
            socket -> socket.address().isAnyLocalAddress() || addresses.contains(socket.address()))
        .mapToInt(ListeningSocket::uid)
        .findFirst();
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
