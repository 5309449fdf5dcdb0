package org.dfra.river.discovery;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.net.Socket;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.dfra.river.discovery.DiscoveryCandidates.LookupAddress;
import org.dfra.river.discovery.UnicastDiscovery.DiscoveryResponse;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The probes of a {@link SharedMulticastSearch}, whose lock guards this. Each queries an announced
 * lookup service, or reads a response to a request. A few run at the same time.
 */
final class DiscoveryProbes {

  /** Accepts responses. */
  @FunctionalInterface
  interface ResponseConsumer {

    /**
     * Accepts a response if it is wanted; false if not. Called on the probe's thread, without the
     * lock.
     *
     * @param host as it was announced, or the address that answered
     * @param place the address that was queried; null for a response to a request
     */
    boolean accept(DiscoveryResponse answer, String host, @Nullable LookupAddress place)
        throws RemoteException;
  }

  private static final Logger LOG = LoggerFactory.getLogger(DiscoveryProbes.class);

  /** For an unknown host: timeout of its connection, and then of its response. */
  private static final Duration UNKNOWN_HOST_TIMEOUT = Duration.ofSeconds(1);

  /** For a host that answered before. */
  private static final Duration KNOWN_HOST_TIMEOUT = Duration.ofSeconds(2);

  /** Maximum number of concurrent probes that read responses to requests. */
  private static final int RESPONSES = DiscoveryCandidates.PROBES / 2;

  private final Object lock; // the search
  private final DiscoveryCandidates hosts;
  private final MulticastRequestSender requests;
  private final DiscoveryThreads threads;
  private final ResponseConsumer taker;

  @GuardedBy("lock")
  private int probing;

  // the part of probing that reads responses to requests
  @GuardedBy("lock")
  private int responding;

  @GuardedBy("lock")
  private @Nullable Future<?> wakeUp;

  @GuardedBy("lock")
  private boolean closed;

  /**
   * @param lock of the search
   * @param hosts the addresses to query
   * @param requests whose responses are read
   */
  DiscoveryProbes(
      Object lock,
      DiscoveryCandidates hosts,
      MulticastRequestSender requests,
      DiscoveryThreads threads,
      ResponseConsumer taker) {
    this.lock = lock;
    this.hosts = hosts;
    this.requests = requests;
    this.threads = threads;
    this.taker = taker;
  }

  /** Starts the probes that may start. Must not be called while holding a lock of the hosts. */
  void dispatch() {
    synchronized (lock) {
      boolean isPossible = true;
      while (isPossible && !closed && probing < DiscoveryCandidates.PROBES) {
        boolean isAnswerRead = responding < RESPONSES && hosts.isRoomForUnknown(responding);
        Optional<Socket> answer = isAnswerRead ? requests.next() : Optional.empty();
        Optional<LookupAddress> place =
            answer.isPresent() ? Optional.empty() : hosts.next(responding);
        if (answer.isPresent()) {
          isPossible = begin(() -> probe(answer.get()), 1);
          if (!isPossible) {
            ResponseListener.drop(answer.get()); // its announcement comes within seconds
          }
        } else if (place.isPresent()) {
          isPossible = begin(() -> probe(place.get()), 0);
          if (!isPossible) {
            hosts.postponed(place.get());
          }
        } else {
          break;
        }
      }
      if (wakeUp != null) {
        wakeUp.cancel(false);
        wakeUp = null;
      }
      if (!closed) {
        Optional<Long> pause =
            isPossible
                ? hosts.untilNext()
                : Optional.of(DiscoveryCandidates.SHORTEST_WAIT.toNanos());
        pause.ifPresent(
            nanos ->
                wakeUp = threads.timer().schedule(this::dispatch, nanos, TimeUnit.NANOSECONDS));
      }
    }
  }

  @GuardedBy("lock")
  private boolean begin(Runnable probe, int responses) {
    boolean isBegun = threads.probe(probe);
    probing += isBegun ? 1 : 0;
    responding += isBegun ? responses : 0;
    return isBegun;
  }

  private void probe(LookupAddress place) {
    boolean isTaken = false;
    try {
      Duration patience = hosts.isKnown(place) ? KNOWN_HOST_TIMEOUT : UNKNOWN_HOST_TIMEOUT;
      DiscoveryResponse answer = UnicastDiscovery.discover(place.host(), place.port(), patience);
      isTaken = taker.accept(answer, place.host(), place);
    } catch (IOException | ClassNotFoundException | RuntimeException e) {
      LOG.debug("No lookup service at {}, where one is announced.", place, e);
    } finally {
      if (!isTaken) {
        hosts.failed(place);
      }
      ended(false);
    }
  }

  private void probe(Socket answering) {
    try (answering) {
      String host = answering.getInetAddress().getHostAddress();
      boolean unused =
          taker.accept(UnicastDiscovery.discover(answering, UNKNOWN_HOST_TIMEOUT), host, null);
    } catch (IOException | ClassNotFoundException | RuntimeException e) {
      LOG.debug("A request was answered by something else than a lookup service.", e);
    } finally {
      ended(true);
    }
  }

  private void ended(boolean wasResponse) {
    synchronized (lock) {
      probing--;
      responding -= wasResponse ? 1 : 0;
    }
    dispatch();
  }

  /** Starts no more probes. Running ones end by their deadlines. */
  void close() {
    synchronized (lock) {
      closed = true;
    }
  }
}
