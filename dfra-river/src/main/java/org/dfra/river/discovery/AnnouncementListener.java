package org.dfra.river.discovery;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import net.jini.discovery.Constants;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Receives the datagrams in which lookup services announce themselves.
 *
 * <p>Threads: one daemon, {@code dfra-discovery-announcements}, from {@link #start} to {@link
 * #close}.
 */
final class AnnouncementListener implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(AnnouncementListener.class);

  private final MulticastSettings settings;
  private final Consumer<DatagramPacket> received;
  private final MulticastSocket socket;
  private List<@Nullable NetworkInterface> failed; // by the thread that joins

  /**
   * Joins the announcements' multicast group on every interface.
   *
   * @param received is given each datagram, on the listener's thread
   * @throws IOException if the port cannot be listened on
   */
  AnnouncementListener(MulticastSettings settings, Consumer<DatagramPacket> received)
      throws IOException {
    this.settings = settings;
    this.received = received;
    this.socket = new MulticastSocket(Constants.discoveryPort);
    this.failed = settings.interfaces();
    join();
  }

  /** Joins where it failed before. One thread at a time. */
  void join() {
    List<@Nullable NetworkInterface> still = new ArrayList<>();
    for (NetworkInterface each : failed) {
      try {
        socket.joinGroup(
            new InetSocketAddress(Constants.getAnnouncementAddress(), Constants.discoveryPort),
            each);
      } catch (IOException e) {
        still.add(each);
        report(settings, each, e);
      }
    }
    failed = still;
  }

  /** An interface that was configured should work; of all the others some never do. */
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
    while (!socket.isClosed()) {
      DatagramPacket packet =
          new DatagramPacket(new byte[settings.packetBytes()], settings.packetBytes());
      try {
        socket.receive(packet);
        received.accept(packet);
      } catch (RuntimeException e) { // a stranger's datagram must not end this thread
        LOG.debug("An announcement could not be handled.", e);
      } catch (IOException e) {
        if (!socket.isClosed()) {
          LOG.warn("Lookup services' announcements are received no more.", e);
          close();
        }
      }
    }
  }

  @Override
  public void close() {
    socket.close();
  }
}
