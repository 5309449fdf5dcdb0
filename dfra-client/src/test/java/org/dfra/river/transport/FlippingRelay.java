package org.dfra.river.transport;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Between a client and a server: it passes on what they send, and changes one bit of what follows
 * the greetings.
 */
final class FlippingRelay implements AutoCloseable {

  /** Both sides wait for more, since the bit was in a length. */
  private static final int SILENCE_MILLIS = 150;

  private static final int HEADER_BYTES = 5;
  private static final int BUFFER = 32 * 1024;

  private final ServerSocket listening;
  private final int target;
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final Set<Socket> sockets = ConcurrentHashMap.newKeySet();
  private volatile Flip next = new Flip(true, -1, 0);
  private volatile boolean isFlipped;
  private volatile boolean isInVersion;

  /**
   * What is changed.
   *
   * @param isOfClient whether it is in what the client sends
   * @param at index of the byte, from the first one after the greeting on
   * @param bit 0 to 7
   */
  record Flip(boolean isOfClient, long at, int bit) {}

  FlippingRelay(int target) throws IOException {
    this.target = target;
    listening = new ServerSocket(0, 50, InetAddress.getByName(RecordingServer.HOST));
    Future<?> unused = threads.submit(this::accept);
  }

  int port() {
    return listening.getLocalPort();
  }

  /** Sets what is changed in the next connection. */
  void set(Flip flip) {
    isFlipped = false;
    isInVersion = false;
    next = flip;
  }

  /** Ends all connections, as the death of both processes' network would. */
  void cut() throws IOException {
    for (Socket each : sockets) {
      each.close();
    }
  }

  /** Whether the connection was long enough for it. */
  boolean isFlipped() {
    return isFlipped;
  }

  /** Whether the bit is in a field that TLS 1.3 ignores: the version of a record. */
  boolean isInVersion() {
    return isInVersion;
  }

  private Object accept() throws IOException {
    while (true) {
      Socket client = listening.accept();
      Socket server = new Socket(RecordingServer.HOST, target);
      for (Socket each : new Socket[] {client, server}) {
        each.setTcpNoDelay(true);
        each.setSoLinger(true, 0);
        sockets.add(each);
      }
      Flip flip = next;
      Future<?> unused =
          threads.submit(() -> relay(client, server, Greeting.CLIENT_BYTES, flip, true));
      Future<?> other =
          threads.submit(() -> relay(server, client, Greeting.SERVER_BYTES, flip, false));
    }
  }

  private Object relay(Socket from, Socket to, int greeting, Flip flip, boolean isOfClient)
      throws IOException {
    try (from;
        to;
        Closeable unused = () -> sockets.removeAll(List.of(from, to))) {
      InputStream in = from.getInputStream();
      OutputStream out = to.getOutputStream();
      out.write(in.readNBytes(greeting));
      if (flip.at() >= 0) {
        from.setSoTimeout(SILENCE_MILLIS);
      }
      byte[] buffer = new byte[BUFFER];
      long passed = 0;
      Records records = new Records();
      for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
        long at = flip.at() - passed;
        boolean isHere = flip.isOfClient() == isOfClient && at >= 0 && at < count;
        for (int i = 0; i < count; i++) {
          boolean isVersion = records.next(buffer[i]);
          if (isHere && i == at) {
            isInVersion = isVersion;
          }
        }
        if (isHere) {
          buffer[(int) at] ^= (byte) (1 << flip.bit());
          isFlipped = true;
        }
        out.write(buffer, 0, count);
        passed += count;
      }
    }
    return flip;
  }

  /** Where the records begin. */
  private static final class Records {
    private int position;
    private int left;

    /** Takes the next byte. Returns whether it is of a record's version. */
    boolean next(byte value) {
      int at = position;
      position++;
      if (at == 3) {
        left = (value & 0xff) << 8;
      } else if (at == 4) {
        left |= value & 0xff;
      }
      if (position >= HEADER_BYTES && position == HEADER_BYTES + left) {
        position = 0;
        left = 0;
      }
      return at == 1 || at == 2;
    }
  }

  @Override
  public void close() throws IOException {
    threads.shutdownNow();
    listening.close();
  }
}
