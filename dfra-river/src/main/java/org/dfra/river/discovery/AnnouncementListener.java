package org.dfra.river.discovery;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import net.jini.discovery.Constants;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Receives the datagrams in which lookup services announce themselves. If its socket fails, for
 * example because an interface was removed, it opens another and joins again, with the delays of
 * {@link ReopenBackoff}; it ends only when it is closed.
 *
 * <p>Threads: one daemon, {@code dfra-discovery-announcements}, from {@link #start} to {@link
 * #close}.
 */
final class AnnouncementListener implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(AnnouncementListener.class);

  /** Opens the socket, without joining a multicast group. */
  @FunctionalInterface
  interface SocketOpener {
    MulticastSocket open() throws IOException;
  }

  private final MulticastSettings settings;
  private final Consumer<DatagramPacket> received;
  private final SocketOpener opening;
  private final ReopenBackoff backoff = new ReopenBackoff();

  @GuardedBy("this")
  private MulticastSocket socket;

  @GuardedBy("this")
  private List<@Nullable NetworkInterface> failed;

  @GuardedBy("this")
  private final Set<@Nullable NetworkInterface> reported = new HashSet<>();

  /**
   * Joins the announcements' multicast group on every interface.
   *
   * @param handler receives each datagram, on the listener's thread
   * @throws IOException if the port cannot be listened on
   */
  AnnouncementListener(MulticastSettings settings, Consumer<DatagramPacket> handler)
      throws IOException {
    this(settings, handler, () -> new MulticastSocket(Constants.discoveryPort));
  }

  /**
   * With sockets of another kind, for tests.
   *
   * @throws IOException if the first cannot be opened
   */
  AnnouncementListener(
      MulticastSettings settings, Consumer<DatagramPacket> handler, SocketOpener opening)
      throws IOException {
    this.settings = settings;
    this.received = handler;
    this.opening = opening;
    this.socket = opening.open();
    this.failed = settings.interfaces();
    join();
  }

  /** Joins on the interfaces where joining failed before. */
  synchronized void join() {
    List<@Nullable NetworkInterface> still = new ArrayList<>();
    for (NetworkInterface each : failed) {
      try {
        socket.joinGroup(
            new InetSocketAddress(Constants.getAnnouncementAddress(), Constants.discoveryPort),
            current(each));
        reported.remove(each);
      } catch (IOException e) {
        still.add(each);
        if (reported.add(each)) {
          report(settings, each, e);
        }
      }
    }
    failed = still;
  }

  /** Looks up an interface by name: one that was removed and added again has another index. */
  private static @Nullable NetworkInterface current(@Nullable NetworkInterface which)
      throws SocketException {
    if (which == null) {
      return null;
    }
    NetworkInterface now = NetworkInterface.getByName(which.getName());
    return now == null ? which : now;
  }

  /** Logs a failure. A configured interface should work; of the others, some never do. */
  static void report(MulticastSettings settings, @Nullable NetworkInterface which, IOException e) {
    String name = which == null ? "of the system's choice" : which.getName();
    if (settings.isListed()) {
      LOG.warn(
          "Lookup services cannot be found by multicast on the interface {} ({}); it is tried"
              + " again.",
          name,
          e.toString());
    } else {
      LOG.debug("No multicast on the interface {}.", name, e);
    }
  }

  void start() {
    Thread thread = new Thread(this::run, "dfra-discovery-announcements");
    thread.setDaemon(true);
    thread.start();
  }

  private void run() {
    while (!backoff.isClosed()) {
      DatagramPacket packet =
          new DatagramPacket(new byte[settings.packetBytes()], settings.packetBytes());
      try {
        socket().receive(packet);
        if (backoff.succeeded()) {
          LOG.info("Lookup services' announcements are received again.");
        }
        received.accept(packet);
      } catch (RuntimeException e) { // an invalid datagram must not end this thread
        LOG.debug("An announcement could not be handled.", e);
      } catch (IOException e) {
        failed(e);
      }
    }
  }

  private synchronized MulticastSocket socket() {
    return socket;
  }

  private void failed(IOException e) {
    if (backoff.failed() && !backoff.isClosed()) {
      LOG.warn(
          "Lookup services' announcements cannot be received now; their port {} is opened again"
              + " until they can.",
          Constants.discoveryPort,
          e);
    }
    if (backoff.await()) {
      reopen();
    }
  }

  /** If that fails, the old socket stays closed, which causes the next attempt. */
  private synchronized void reopen() {
    socket.close();
    try {
      socket = opening.open();
    } catch (IOException e) {
      LOG.debug("Port {} cannot be opened yet.", Constants.discoveryPort, e);
      return;
    }
    if (backoff.isClosed()) {
      socket.close();
    } else {
      failed = settings.interfaces();
      join();
    }
  }

  @Override
  public void close() {
    backoff.close();
    synchronized (this) {
      socket.close();
    }
  }
}
