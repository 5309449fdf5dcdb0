package org.dfra.river.discovery;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.river.lookup.SuppliedConfiguration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A socket that fails does not end its listener. */
@Timeout(60)
class FailingListenersTest {

  private static final long PATIENCE_SECONDS = 20;
  private static final int BACKLOG = 50;
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  /** Its network is not reachable. */
  private static final class CutMulticastSocket extends MulticastSocket {

    CutMulticastSocket() throws IOException {
      super(new InetSocketAddress(LOOPBACK, 0));
    }

    @Override
    public void receive(DatagramPacket packet) throws IOException {
      throw new SocketException("Network is unreachable");
    }
  }

  /** It accepts nothing. */
  private static final class CutServerSocket extends ServerSocket {

    CutServerSocket() throws IOException {
      super(0, BACKLOG, LOOPBACK);
    }

    @Override
    public Socket accept() throws IOException {
      throw new SocketException("Network is unreachable");
    }
  }

  private final AtomicInteger opened = new AtomicInteger();
  private final List<AutoCloseable> ending = new ArrayList<>();

  @AfterEach
  void end() throws Exception {
    for (AutoCloseable each : ending) {
      each.close();
    }
  }

  private static <T> T next(BlockingQueue<T> queue) throws InterruptedException {
    T next = queue.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
    assertThat(next).as("within %s s", PATIENCE_SECONDS).isNotNull();
    return next;
  }

  /** The second socket cannot be opened; the third works. */
  @Test
  void announcementsAreReceivedByAnotherSocketWhereOneFails() throws Exception {
    NetworkInterface[] none = {};
    MulticastSettings settings =
        MulticastSettings.of(
            new SuppliedConfiguration(
                Map.of(MulticastSettings.COMPONENT + ".multicastInterfaces", () -> none)));
    BlockingQueue<MulticastSocket> working = new LinkedBlockingQueue<>();
    BlockingQueue<byte[]> received = new LinkedBlockingQueue<>();
    AnnouncementListener.SocketOpener opening =
        () -> {
          int number = opened.incrementAndGet();
          if (number == 1) {
            return new CutMulticastSocket();
          } else if (number == 2) {
            throw new SocketException("No buffer space available");
          }
          MulticastSocket socket = new MulticastSocket(new InetSocketAddress(LOOPBACK, 0));
          working.add(socket);
          return socket;
        };
    AnnouncementListener listener =
        new AnnouncementListener(
            settings, packet -> received.add(new byte[packet.getLength()]), opening);
    ending.add(listener);
    listener.start();
    MulticastSocket socket = next(working);
    try (DatagramSocket sender = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0))) {
      for (int length : new int[] {3, 5}) {
        sender.send(new DatagramPacket(new byte[length], length, LOOPBACK, socket.getLocalPort()));
        assertThat(next(received)).hasSize(length);
      }
    }
    assertThat(opened).as("a socket that works is kept").hasValue(3);
    listener.close();
    assertThat(socket.isClosed()).isTrue();
    assertThat(working).isEmpty();
  }

  @Test
  void responsesAreReceivedAtTheSamePortWhereItsSocketFails() throws Exception {
    BlockingQueue<ServerSocket> working = new LinkedBlockingQueue<>();
    BlockingQueue<Integer> ports = new LinkedBlockingQueue<>();
    BlockingQueue<Integer> responses = new LinkedBlockingQueue<>();
    AtomicInteger responded = new AtomicInteger();
    ResponseListener.ServerSocketOpener opening =
        port -> {
          if (opened.incrementAndGet() == 1) {
            ServerSocket cut = new CutServerSocket();
            ports.add(cut.getLocalPort());
            return cut;
          }
          ServerSocket socket = new ServerSocket(port, BACKLOG, LOOPBACK);
          working.add(socket);
          return socket;
        };
    ResponseListener listener =
        ResponseListener.start(
            () -> {
              int number = responded.incrementAndGet();
              responses.add(number);
              if (number == 1) {
                throw new IllegalStateException("a fault of what is run");
              }
            },
            opening);
    ending.add(listener);
    ServerSocket socket = next(working);
    int port = next(ports);
    assertThat(socket.getLocalPort()).as("the port that requests have named").isEqualTo(port);
    connect(port);
    assertThat(next(responses)).isEqualTo(1);
    connect(port);
    assertThat(next(responses)).as("the listener goes on").isEqualTo(2);
    assertThat(listener.port()).isEqualTo(port);
    listener.close();
    assertThat(socket.isClosed()).isTrue();
    assertThat(listener.next()).as("what waited is closed").isEmpty();
  }

  @Test
  void responsesAreReceivedAtAnotherPortWhereThatIsTaken() throws Exception {
    BlockingQueue<ServerSocket> working = new LinkedBlockingQueue<>();
    BlockingQueue<String> responses = new LinkedBlockingQueue<>();
    ResponseListener.ServerSocketOpener opening =
        port -> {
          if (opened.incrementAndGet() == 1) {
            return new CutServerSocket();
          } else if (port != 0) {
            throw new BindException("Address already in use");
          }
          ServerSocket socket = new ServerSocket(0, BACKLOG, LOOPBACK);
          working.add(socket);
          return socket;
        };
    ResponseListener listener = ResponseListener.start(() -> responses.add("one"), opening);
    ending.add(listener);
    int port = next(working).getLocalPort();
    connect(port);
    assertThat(next(responses)).isEqualTo("one");
    assertThat(listener.port()).isEqualTo(port);
    ending.add(listener.next().orElseThrow());
  }

  private void connect(int port) throws IOException {
    ending.add(new Socket(LOOPBACK, port));
  }

  /** One that stalls holds up one check, not all. */
  @Test
  void asManyChecksAreMadeAtOnceAsProbes() throws Exception {
    DiscoveryThreads threads = DiscoveryThreads.begin();
    BlockingQueue<String> begun = new LinkedBlockingQueue<>();
    BlockingQueue<String> over = new LinkedBlockingQueue<>();
    try {
      for (int i = 0; i < DiscoveryThreads.CHECKS - 1; i++) {
        threads
            .checks()
            .execute(
                () -> {
                  begun.add("stalls");
                  try {
                    over.take();
                  } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                  }
                });
        assertThat(next(begun)).isEqualTo("stalls");
      }
      threads.checks().execute(() -> begun.add("answers"));
      assertThat(next(begun)).isEqualTo("answers");
      assertThat(threads.checks().getMaximumPoolSize()).isEqualTo(DiscoveryCandidates.PROBES);
    } finally {
      threads.end();
    }
  }
}
