package org.dfra.river.discovery;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.Socket;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import net.jini.core.lookup.ServiceID;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Requests the lookup services of some groups by multicast. A round is a few requests. Lookup
 * services answer by connecting to a {@link ResponseListener}, which listens until the last round
 * ends.
 *
 * <p>It runs on the search's timer thread.
 */
final class MulticastRequestSender implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(MulticastRequestSender.class);

  private final MulticastSettings settings;
  private final ScheduledExecutorService timer;
  private final Supplier<Collection<ServiceID>> known;
  private final Runnable responded;

  // while there is a round
  @GuardedBy("this")
  private @Nullable ResponseListener responses;

  @GuardedBy("this")
  private int rounds;

  // whether the first round was started
  @GuardedBy("this")
  private boolean isDelayed;

  @GuardedBy("this")
  private boolean closed;

  /**
   * @param known supplies the lookup services that need not answer; called without a lock
   * @param onResponse runs when {@link #next} has a connection, on another thread
   */
  MulticastRequestSender(
      MulticastSettings settings,
      ScheduledExecutorService timer,
      Supplier<Collection<ServiceID>> known,
      Runnable onResponse) {
    this.settings = settings;
    this.timer = timer;
    this.known = known;
    this.responded = onResponse;
  }

  /**
   * Starts a round.
   *
   * @param groups those whose members are to answer; all if empty
   * @throws IOException if there is no port for the responses
   */
  synchronized void begin(List<String> groups) throws IOException {
    if (closed || settings.requests() < 1 || settings.interfaces().isEmpty()) {
      return;
    }
    if (responses == null) {
      responses = ResponseListener.start(responded);
    }
    rounds++;
    long range = isDelayed ? 0 : settings.requestDelay().toMillis();
    isDelayed = true;
    after(Duration.ofMillis((long) (Math.random() * range)), groups, settings.requests());
  }

  private synchronized void after(Duration pause, List<String> groups, int left) {
    if (!closed) {
      Future<?> unused =
          timer.schedule(() -> request(groups, left), pause.toMillis(), TimeUnit.MILLISECONDS);
    }
  }

  private void request(List<String> groups, int left) {
    int port = left == 0 ? end() : port();
    if (port == 0) {
      return;
    }
    try {
      send(DiscoveryPackets.encodeRequest(settings, port, groups, known.get()));
    } catch (IOException | RuntimeException e) {
      LOG.warn("No request for lookup services of the groups {} could be sent.", groups, e);
    }
    after(
        left == 1 ? settings.finalRequestInterval() : settings.requestInterval(), groups, left - 1);
  }

  /** The port for responses; 0 when closed. */
  private synchronized int port() {
    return responses == null ? 0 : responses.port();
  }

  private synchronized int end() {
    rounds--;
    if (rounds == 0 && responses != null) {
      responses.close();
      responses = null;
    }
    return 0;
  }

  private void send(List<DatagramPacket> packets) throws IOException {
    try (MulticastSocket socket = new MulticastSocket()) {
      socket.setTimeToLive(settings.timeToLive());
      for (NetworkInterface each : settings.interfaces()) {
        try {
          if (each != null) {
            socket.setNetworkInterface(each);
          }
          for (DatagramPacket packet : packets) {
            socket.send(packet);
          }
        } catch (IOException e) {
          AnnouncementListener.report(settings, each, e);
        }
      }
    }
  }

  /** A connection of a lookup service that responds; the caller closes it. */
  synchronized Optional<Socket> next() {
    return responses == null ? Optional.empty() : responses.next();
  }

  @Override
  public synchronized void close() {
    closed = true;
    if (responses != null) {
      responses.close();
      responses = null;
    }
  }
}
