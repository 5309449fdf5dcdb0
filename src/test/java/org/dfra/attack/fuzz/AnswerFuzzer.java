package org.dfra.attack.fuzz;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * A server that answers unicast discovery with the answer of an honest lookup service, changed at
 * random. The first client, and each one after {@link #beHonest}, speaks with the honest one
 * itself; the answer to the first is the one that is changed.
 *
 * <p>One thread serves one client after the other, until {@link #close}; a further one carries
 * bytes while a client speaks with the honest server.
 */
final class AnswerFuzzer implements AutoCloseable {

  private static final int REQUEST = 4096;
  private static final int SOCKET_MILLIS = 2_000;

  /** The first of the connections that end otherwise are reported, the others counted. */
  private static final int REPORTED = 100;

  private final ServerSocket server;
  private final String host;
  private final int honestPort;
  private final ByteMutator mutator;
  private byte[] recorded = {}; // by the thread
  private int answers; // guarded by this
  private int broken; // guarded by this
  private boolean honest; // guarded by this

  /**
   * Starts it.
   *
   * @param host where it and the honest lookup service listen
   * @param honestPort the honest one's port for unicast discovery
   */
  AnswerFuzzer(String host, int honestPort, ByteMutator mutator) throws IOException {
    this.host = host;
    this.honestPort = honestPort;
    this.mutator = mutator;
    this.server = new ServerSocket(0, 50, InetAddress.getByName(host));
    Thread thread = new Thread(this::serve, "changed answers of discovery");
    thread.setDaemon(true);
    thread.start();
  }

  /** Where it is found: {@code jini://host:port}. */
  String locator() {
    return "jini://" + host + ":" + server.getLocalPort();
  }

  /** From now on, changes nothing. */
  synchronized void beHonest() {
    honest = true;
  }

  private synchronized boolean isHonest() {
    return honest;
  }

  /**
   * Waits until so many changed answers were given.
   *
   * @throws TimeoutException if they were not in time; its message has how many were
   */
  synchronized void awaitAnswers(int count, long seconds)
      throws InterruptedException, TimeoutException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
    while (answers < count) {
      long left = end - System.nanoTime();
      if (left <= 0) {
        throw new TimeoutException(
            answers + " of " + count + " answers were asked for within " + seconds + " s");
      }
      TimeUnit.NANOSECONDS.timedWait(this, left);
    }
  }

  /** How many connections ended otherwise than by the client's closing them after the answer. */
  synchronized int broken() {
    return broken;
  }

  private void report(String what, IOException e) {
    int count;
    synchronized (this) {
      count = ++broken;
    }
    if (count <= REPORTED) { // of a million answers, many
      System.err.println(what + ": " + e);
    }
  }

  private void serve() {
    while (!server.isClosed()) {
      try (Socket client = server.accept()) {
        client.setSoTimeout(SOCKET_MILLIS);
        if (isHonest() || recorded.length == 0) {
          recorded = relay(client);
        } else {
          answer(client, mutator.mutate(recorded));
        }
      } catch (IOException e) {
        if (!server.isClosed()) {
          report("a client of discovery ended early", e); // it may
        }
      }
    }
  }

  /** Lets a client speak with the honest server, and returns what that answered. */
  private byte[] relay(Socket client) throws IOException {
    ByteArrayOutputStream answer = new ByteArrayOutputStream();
    try (Socket to = new Socket(host, honestPort)) {
      to.setSoTimeout(SOCKET_MILLIS);
      Thread requests = new Thread(() -> carry(client, to), "requests of discovery");
      requests.setDaemon(true);
      requests.start();
      InputStream from = to.getInputStream();
      OutputStream back = client.getOutputStream();
      byte[] buffer = new byte[REQUEST];
      for (int length; (length = from.read(buffer)) > 0; ) {
        answer.write(buffer, 0, length);
        back.write(buffer, 0, length);
      }
    }
    return answer.toByteArray();
  }

  private static void carry(Socket client, Socket to) {
    try {
      long unused = client.getInputStream().transferTo(to.getOutputStream());
    } catch (IOException e) {
      System.err.println("a request of discovery has ended: " + e); // with the answer
    }
  }

  /** Answers, and waits until the client closes: a reset would discard the answer. */
  private void answer(Socket client, byte[] bytes) throws IOException {
    byte[] request = new byte[REQUEST];
    if (client.getInputStream().read(request) > 0) {
      client.getOutputStream().write(bytes);
      client.shutdownOutput();
      synchronized (this) {
        answers++;
        notifyAll();
      }
      try {
        while (client.getInputStream().read(request) > 0) {
          continue;
        }
      } catch (SocketTimeoutException e) {
        report("a client of discovery does not close", e); // it is left alone
      }
    }
  }

  @Override
  public void close() throws IOException {
    server.close();
  }
}
