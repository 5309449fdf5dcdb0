package org.dfra.core.host;

import java.io.IOException;
import java.net.BindException;
import java.net.ServerSocket;
import java.security.SecureRandom;
import java.util.HashSet;
import java.util.Random;
import java.util.Set;

/**
 * TCP ports for servers that are told their port before they start: those of demonstrations and
 * tests, several robots on one host.
 *
 * <p>Whoever binds port 0 and lets go is given a port out of the range from which the kernel also
 * takes the near ends of outgoing connections, so that any program may have taken it by the time
 * the server opens it; and a server that is killed and started again finds its port taken by a
 * connection. The ports given here lie below that range (which is 32768 to 60999 on Linux and
 * begins at 49152 elsewhere), are drawn at random, so that two programs at once hardly draw the
 * same, and are given once only in one virtual machine.
 */
public final class FreePorts {

  /** The least port that is given. */
  static final int FIRST = 20_000;

  /** One more than the greatest port that is given. */
  static final int END = 32_768;

  private static final Random RANDOM = new SecureRandom();
  private static final Set<Integer> GIVEN = new HashSet<>();

  private FreePorts() {}

  /**
   * A port on which nobody listens now, on any address of this host, and which was not given
   * before.
   *
   * @throws IOException when all of them are taken
   */
  public static synchronized int allocate() throws IOException {
    int start = FIRST + RANDOM.nextInt(END - FIRST);
    for (int offset = 0; offset < END - FIRST; offset++) {
      int port = FIRST + (start - FIRST + offset) % (END - FIRST);
      if (!GIVEN.contains(port) && isFree(port)) {
        GIVEN.add(port);
        return port;
      }
    }
    throw new IOException(
        "No TCP port from %d to %d is free on this host; end the programs that listen there"
            .formatted(FIRST, END - 1));
  }

  private static boolean isFree(int port) throws IOException {
    try (ServerSocket socket = new ServerSocket(port)) {
      return socket.isBound();
    } catch (BindException e) { // somebody listens there
      return false;
    }
  }
}
