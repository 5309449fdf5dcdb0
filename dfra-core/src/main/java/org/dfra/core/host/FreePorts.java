package org.dfra.core.host;

import java.io.IOException;
import java.net.BindException;
import java.net.ServerSocket;
import java.security.SecureRandom;
import java.util.HashSet;
import java.util.Random;
import java.util.Set;

/**
 * Allocates TCP ports for servers that must know their port before they start: in demonstrations
 * and tests with several robots on one host.
 *
 * <p>Binding port 0 and closing it yields an ephemeral port. The kernel also uses that range for
 * outgoing connections, so any program may take the port before the server opens it, and a server
 * that is killed and restarted may find its port used by a connection. The ports allocated here are
 * below that range (32768 to 60999 on Linux, from 49152 elsewhere). They are random, so that two
 * concurrent programs are unlikely to choose the same one, and each is allocated only once in a
 * virtual machine.
 */
public final class FreePorts {

  /** The lowest port. */
  static final int FIRST = 20_000;

  /** One more than the highest port. */
  static final int END = 32_768;

  private static final Random RANDOM = new SecureRandom();
  private static final Set<Integer> GIVEN = new HashSet<>();

  private FreePorts() {}

  /**
   * A port on which no process listens, on any address of this host, and which was not allocated
   * before.
   *
   * @throws IOException if all of them are in use
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
    } catch (BindException e) { // the port is in use
      return false;
    }
  }
}
