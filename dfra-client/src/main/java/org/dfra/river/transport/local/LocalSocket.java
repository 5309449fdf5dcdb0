package org.dfra.river.transport.local;

import java.nio.file.Path;
import java.util.Objects;
import net.jini.id.Uuid;

/**
 * Where the clients on a server's own computer connect: a Unix-domain socket.
 *
 * @param computer the server's {@link ComputerId}
 * @param path of the socket
 * @param server ID of the server, which the greeting names: two computers may have equal paths
 */
public record LocalSocket(String computer, String path, Uuid server) {

  /** The longest path, in bytes, that the operating system accepts. */
  public static final int MAX_PATH_BYTES = 107;

  public LocalSocket {
    Objects.requireNonNull(computer, "computer");
    Objects.requireNonNull(path, "path");
    Objects.requireNonNull(server, "server");
    if (path.isEmpty() || path.length() > MAX_PATH_BYTES) {
      throw new IllegalArgumentException(
          "the path of a socket has "
              + path.length()
              + " characters; it must have 1 to "
              + MAX_PATH_BYTES);
    }
    Path unused = Path.of(path); // throws if it is none
  }

  /** Whether this program runs on the server's computer. */
  public boolean isHere() {
    return !computer.isEmpty() && computer.equals(ComputerId.OWN);
  }
}
