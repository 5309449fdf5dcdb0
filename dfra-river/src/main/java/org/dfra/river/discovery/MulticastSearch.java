package org.dfra.river.discovery;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import com.sun.jini.discovery.MulticastAnnouncement;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.lookup.ServiceID;
import org.dfra.river.discovery.DiscoveryCandidates.LookupAddress;
import org.dfra.river.discovery.FoundRegistrars.FoundRegistrar;
import org.dfra.river.discovery.UnicastDiscovery.DiscoveryResponse;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds the lookup services of some groups by multicast, until it is closed. It replaces River's
 * {@code LookupDiscovery} and reads the same configuration entries. A hundred forged announcements
 * a second delay River's class by seconds. Here {@link DiscoveryCandidates} selects the addresses
 * and limits the concurrent queries, and {@link UnicastDiscovery} reads the responses.
 *
 * <p>A lookup service is identified by its proxy and not only by its service ID, which any host may
 * copy: all that claim one service ID are found, see {@link LocatedRegistrar}.
 *
 * <p>Threads, all daemons: {@code dfra-discovery-timer} sends requests and reports results; up to
 * {@value DiscoveryCandidates#PROBES} {@code dfra-discovery-probe}; as many {@code
 * dfra-discovery-check}, which query the found lookup services for their groups, if these may have
 * changed or announcements have stopped; those of {@link AnnouncementListener} and {@link
 * ResponseListener}.
 */
public final class MulticastSearch implements AutoCloseable {

  /**
   * Receives the found and lost lookup services, one after the other, on the search's timer thread.
   */
  public interface Listener {

    /** A lookup service was found. */
    void found(LocatedRegistrar registrar);

    /** A lookup service no longer answers, or left the groups. Not after a discard. */
    void lost(LocatedRegistrar registrar);
  }

  private static final Logger LOG = LoggerFactory.getLogger(MulticastSearch.class);

  /** The number of announcements that may be missed. */
  private static final int MISSED = 3;

  /** The minimum time between two queries of a lookup service for its groups. */
  private static final Duration BETWEEN_CHECKS = Duration.ofSeconds(5);

  private final MulticastSettings settings;
  private final Listener listener;
  private final DiscoveryCandidates hosts = new DiscoveryCandidates(System::nanoTime);

  @GuardedBy("this")
  private final FoundRegistrars found = new FoundRegistrars();

  private final DiscoveryThreads threads;
  private final MulticastRequestSender requests;
  private final DiscoveryProbes probes;
  private final @Nullable AnnouncementListener announcements;

  @GuardedBy("this")
  private final WantedGroups groups;

  @GuardedBy("this")
  private boolean closed;

  /**
   * Starts the search.
   *
   * @param groups the groups; null for all
   * @param configuration entries of {@code net.jini.discovery.LookupDiscovery}
   * @throws IOException if multicast cannot be used
   * @throws ConfigurationException if an entry is invalid
   */
  public static MulticastSearch start(
      String @Nullable [] groups, Configuration configuration, Listener listener)
      throws IOException, ConfigurationException {
    return start(groups, MulticastSettings.of(configuration), listener, DiscoveryThreads.begin());
  }

  static MulticastSearch start(
      String @Nullable [] groups,
      MulticastSettings settings,
      Listener listener,
      DiscoveryThreads threads)
      throws IOException {
    MulticastSearch search = new MulticastSearch(groups, settings, listener, threads);
    search.begin(groups);
    return search;
  }

  private MulticastSearch(
      String @Nullable [] groups,
      MulticastSettings settings,
      Listener listener,
      DiscoveryThreads threads)
      throws IOException {
    this.threads = threads;
    this.settings = settings;
    this.listener = listener;
    this.groups = new WantedGroups(groups);
    this.requests =
        new MulticastRequestSender(settings, threads.timer(), this::identities, this::dispatch);
    this.probes = new DiscoveryProbes(this, hosts, requests, threads, this::hold);
    boolean isDisabled = settings.interfaces().isEmpty();
    try {
      this.announcements = isDisabled ? null : new AnnouncementListener(settings, this::received);
    } catch (IOException e) {
      threads.end();
      throw e;
    }
  }

  private void begin(String @Nullable [] wanted) throws IOException {
    if (announcements != null) {
      try {
        announcements.start();
        every(settings.announcementInterval(), this::checkSilent);
        every(settings.interfaceRetry(), announcements::join);
        if (wanted == null || wanted.length > 0) {
          requests.begin(wanted == null ? List.of() : List.of(wanted));
        }
      } catch (IOException e) {
        close();
        throw e;
      }
    }
  }

  private void every(Duration interval, Runnable task) {
    long millis = Math.max(1, interval.toMillis());
    Future<?> unused =
        threads.timer().scheduleWithFixedDelay(task, millis, millis, TimeUnit.MILLISECONDS);
  }

  private synchronized Collection<ServiceID> identities() {
    return found.serviceIds();
  }

  /** The groups, without duplicates; null for all. */
  public synchronized String @Nullable [] getGroups() {
    return groups.names();
  }

  /**
   * Adds groups to the search.
   *
   * @throws UnsupportedOperationException if it searches for all
   * @throws IOException if multicast cannot be used
   */
  public synchronized void addGroups(String[] more) throws IOException {
    List<String> added = groups.add(more);
    if (!added.isEmpty()) {
      requests.begin(added);
    }
  }

  /**
   * Replaces the groups of the search; lookup services that are in none of them are lost.
   *
   * @param wanted the groups; null for all
   * @throws IOException if multicast cannot be used
   */
  public synchronized void setGroups(String @Nullable [] wanted) throws IOException {
    Optional<List<String>> added = groups.set(wanted);
    if (added.isPresent()) {
      requests.begin(added.get());
    }
    loseUnwanted();
  }

  /**
   * Removes groups from the search; lookup services that are in no other group are lost.
   *
   * @throws UnsupportedOperationException if it searches for all
   */
  public synchronized void removeGroups(String[] unwanted) {
    groups.remove(unwanted);
    loseUnwanted();
  }

  @GuardedBy("this")
  private void loseUnwanted() {
    for (FoundRegistrar each : found.all()) {
      if (!groups.matchesAny(each.groups)) {
        lose(each);
      }
    }
  }

  // Announcements, on the thread that receives them.

  /** Handles a datagram. Also for tests. */
  void received(DatagramPacket packet) {
    Optional<MulticastAnnouncement> announcement = DiscoveryPackets.decodeAnnouncement(packet);
    announcement.ifPresent(each -> announced(each, packet.getAddress()));
  }

  private void announced(MulticastAnnouncement announcement, InetAddress from) {
    ServiceID id = announcement.getServiceID();
    List<String> members = List.of(announcement.getGroups());
    String host = announcement.getHost();
    synchronized (this) {
      if (closed) {
        return;
      }
      List<FoundRegistrar> known = found.of(id, host);
      for (FoundRegistrar each : known) {
        each.seenAt = System.nanoTime();
        if (!Set.copyOf(members).equals(Set.copyOf(each.groups))) {
          check(each);
        }
      }
      if (known.isEmpty() && !groups.matchesAny(members)) {
        return;
      }
    }
    hosts.announced(
        new LookupAddress(host, announcement.getPort()), id, from.getHostAddress().equals(host));
    dispatch();
  }

  /** Starts the probes that may start. Must not be called while holding a lock of the hosts. */
  private void dispatch() {
    probes.dispatch();
  }

  /**
   * Accepts a response if it is wanted; false if not.
   *
   * @param place the address that was queried; null for a response to a request
   */
  private boolean hold(DiscoveryResponse answer, String host, @Nullable LookupAddress place)
      throws RemoteException {
    synchronized (this) {
      if (!groups.matchesAny(answer.groups())) {
        return false;
      }
    }
    LocatedRegistrar registrar = answer.registrar().prepared(settings.preparer());
    synchronized (this) {
      if (closed || !groups.matchesAny(answer.groups()) || !found.isRoomFor(registrar)) {
        return false;
      }
      if (place != null) {
        hosts.succeeded(place, registrar);
      }
      FoundRegistrar held = new FoundRegistrar(registrar, host, answer.groups(), System.nanoTime());
      if (found.add(held)) {
        threads.timer().execute(() -> listener.found(registrar));
      }
      return true;
    }
  }

  /** Whether a lookup service that claims this service ID is found now. */
  public synchronized boolean isDiscovered(ServiceID id) {
    return found.serviceIds().contains(id);
  }

  /** Whether this lookup service is found now. */
  public synchronized boolean isDiscovered(LocatedRegistrar registrar) {
    return found.contains(registrar);
  }

  /** Removes a lookup service that does not answer, and searches for it again. */
  public void discard(LocatedRegistrar registrar) {
    synchronized (this) {
      if (!found.remove(registrar)) {
        return;
      }
      hosts.lost(registrar);
    }
    dispatch();
  }

  private synchronized void lose(FoundRegistrar lost) {
    if (found.remove(lost)) {
      hosts.lost(lost.registrar);
      threads.timer().execute(() -> listener.lost(lost.registrar));
    }
  }

  /** Checks the lookup services without a recent announcement. On the timer's thread. */
  private synchronized void checkSilent() {
    long longest = settings.announcementInterval().multipliedBy(MISSED).toNanos();
    long now = System.nanoTime();
    found.all().stream().filter(each -> now - each.seenAt > longest).forEach(this::check);
  }

  /** Starts a query of a lookup service for its groups, unless there was one just now. */
  private synchronized void check(FoundRegistrar which) {
    long now = System.nanoTime();
    boolean isDue = now - which.checkedAt > BETWEEN_CHECKS.toNanos();
    if (!closed && isDue && !which.isBeingChecked) {
      which.checkedAt = now;
      // if no thread is available, it is checked the next time
      which.isBeingChecked = threads.check(() -> askForGroups(which));
    }
  }

  private void askForGroups(FoundRegistrar which) {
    try {
      List<String> actual = List.of(which.registrar.getGroups());
      synchronized (this) {
        which.groups = actual;
        which.seenAt = System.nanoTime();
        if (!closed && !groups.matchesAny(actual)) {
          lose(which);
        }
      }
    } catch (RemoteException | RuntimeException e) {
      LOG.debug("A lookup service does not answer any more.", e);
      synchronized (this) {
        if (!closed) {
          lose(which);
        }
      }
      dispatch();
    } finally {
      endCheck(which);
    }
  }

  private synchronized void endCheck(FoundRegistrar which) {
    which.isBeingChecked = false;
  }

  /** Ends the search. Running probes end by their deadlines. Idempotent. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      probes.close();
      found.clear();
    }
    requests.close();
    threads.end();
    if (announcements != null) {
      announcements.close();
    }
  }
}
