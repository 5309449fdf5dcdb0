package org.dfra.river.discovery;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import com.sun.jini.discovery.MulticastAnnouncement;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import net.jini.core.lookup.ServiceID;
import org.dfra.river.discovery.DiscoveryCandidates.LookupAddress;
import org.dfra.river.discovery.FoundRegistrars.FoundRegistrar;
import org.dfra.river.discovery.UnicastDiscovery.DiscoveryResponse;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds the lookup services of all groups that some {@link MulticastSearch}es search for. A hundred
 * forged announcements a second delay River's class by seconds. Here {@link DiscoveryCandidates}
 * selects the addresses and limits the concurrent queries, and {@link UnicastDiscovery} reads the
 * responses.
 *
 * <p>Threads, all daemons: {@code dfra-discovery-timer} sends requests and reports results; up to
 * {@value DiscoveryCandidates#PROBES} {@code dfra-discovery-probe}; as many {@code
 * dfra-discovery-check}, which query the found lookup services for their groups, if these may have
 * changed or announcements have stopped; those of {@link AnnouncementListener} and {@link
 * ResponseListener}. They end with the last user.
 */
final class SharedMulticastSearch {

  private static final Logger LOG = LoggerFactory.getLogger(MulticastSearch.class);

  /** The number of announcements that may be missed. */
  private static final int MISSED = 3;

  /** The minimum time between two queries of a lookup service for its groups. */
  private static final Duration BETWEEN_CHECKS = Duration.ofSeconds(5);

  /** Stands for all groups; no group has this name. */
  private static final String ALL = "*\u0000";

  /** Those with users, by what users must have in common. */
  @GuardedBy("OPEN")
  private static final Map<Shareable, SharedMulticastSearch> OPEN = new HashMap<>();

  /** The context class loader reads the proxies that are found, which get the identity. */
  private record Shareable(
      MulticastSettings settings,
      @Nullable ClassLoader loader,
      @Nullable ChannelIdentity identity) {}

  /** What one {@link MulticastSearch} searches for and has found. */
  static final class User {

    private final MulticastSearch.Listener listener;
    private final WantedGroups groups; // guarded by the shared search, like the next field
    private final Set<LocatedRegistrar> reported = new HashSet<>();

    /**
     * @param groups null for all
     */
    User(String @Nullable [] groups, MulticastSearch.Listener listener) {
      this.groups = new WantedGroups(groups);
      this.listener = listener;
    }
  }

  private final MulticastSettings settings;
  private final DiscoveryCandidates hosts = new DiscoveryCandidates(System::nanoTime);

  @GuardedBy("this")
  private final FoundRegistrars found = new FoundRegistrars();

  private final DiscoveryThreads threads;
  private final MulticastRequestSender requests;
  private final DiscoveryProbes probes;
  private final @Nullable AnnouncementListener announcements;

  @GuardedBy("this")
  private final List<User> users = new ArrayList<>();

  /** When requests for a group began, nanoseconds of the system. */
  @GuardedBy("this")
  private final Map<String, Long> requestedAt = new HashMap<>();

  @GuardedBy("this")
  private boolean isBegun;

  @GuardedBy("this")
  private boolean closed;

  /**
   * A search without users, which does nothing yet. The first user begins it.
   *
   * @throws IOException if multicast cannot be used
   */
  SharedMulticastSearch(MulticastSettings settings, DiscoveryThreads threads) throws IOException {
    this.threads = threads;
    this.settings = settings;
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

  /**
   * Adds a user to the search with these settings; begins one if there is none.
   *
   * @throws IOException if multicast cannot be used
   */
  static SharedMulticastSearch join(MulticastSettings settings, User user) throws IOException {
    Shareable shareable =
        new Shareable(
            settings, Thread.currentThread().getContextClassLoader(), CurrentIdentity.get());
    synchronized (OPEN) {
      SharedMulticastSearch search = OPEN.get(shareable);
      if (search == null) {
        search = new SharedMulticastSearch(settings, DiscoveryThreads.begin());
      }
      search.add(user);
      OPEN.put(shareable, search);
      return search;
    }
  }

  /** Removes a user; the last one ends the search. */
  void leave(User user) {
    synchronized (OPEN) {
      synchronized (this) {
        users.remove(user);
        if (!users.isEmpty()) {
          loseUnwanted();
          return;
        }
      }
      OPEN.values().remove(this);
    }
    close();
  }

  /**
   * Adds a user, and reports to it those that are found already.
   *
   * @throws IOException if multicast cannot be used; without users, the search is closed then
   */
  void add(User user) throws IOException {
    try {
      synchronized (this) {
        begin();
        request(user.groups.names());
        users.add(user);
        reportAll(user);
      }
    } catch (IOException e) {
      leave(user);
      throw e;
    }
  }

  @GuardedBy("this")
  private void begin() throws IOException {
    if (announcements != null && !isBegun) {
      isBegun = true;
      announcements.start();
      every(settings.announcementInterval(), this::checkSilent);
      every(settings.interfaceRetry(), announcements::join);
    }
  }

  /**
   * Sends requests for groups, except for those of which a member is found, or whose requests for
   * another user are still being sent.
   *
   * @param wanted null for all
   */
  @GuardedBy("this")
  private void request(String @Nullable [] wanted) throws IOException {
    if (closed) {
      return;
    }
    if (wanted == null) {
      if (isDue(ALL)) {
        requests.begin(List.of());
      }
      return;
    }
    List<FoundRegistrar> known = found.all();
    List<String> missing = new ArrayList<>();
    for (String each : wanted) {
      if (known.stream().noneMatch(one -> one.groups.contains(each)) && isDue(each)) {
        missing.add(each);
      }
    }
    if (!missing.isEmpty()) {
      requests.begin(missing);
    }
  }

  /** Whether no requests for a group are being sent; then they are from now on. */
  @GuardedBy("this")
  private boolean isDue(String group) {
    long now = System.nanoTime();
    long round = settings.requestInterval().multipliedBy(settings.requests()).toNanos();
    requestedAt.values().removeIf(each -> now - each > round);
    return requestedAt.putIfAbsent(group, now) == null;
  }

  private void every(Duration interval, Runnable task) {
    long millis = Math.max(1, interval.toMillis());
    Future<?> unused =
        threads.timer().scheduleWithFixedDelay(task, millis, millis, TimeUnit.MILLISECONDS);
  }

  private synchronized Collection<ServiceID> identities() {
    return found.serviceIds();
  }

  synchronized String @Nullable [] groups(User user) {
    return user.groups.names();
  }

  /** Those that a user knows of now. */
  synchronized Set<LocatedRegistrar> known(User user) {
    return Set.copyOf(user.reported);
  }

  synchronized void addGroups(User user, String[] more) throws IOException {
    List<String> added = user.groups.add(more);
    reportAll(user);
    request(added.toArray(String[]::new));
  }

  synchronized void setGroups(User user, String @Nullable [] wanted) throws IOException {
    Optional<List<String>> added = user.groups.set(wanted);
    reportAll(user);
    loseUnwanted();
    if (added.isPresent()) {
      request(wanted == null ? null : added.get().toArray(String[]::new));
    }
  }

  synchronized void removeGroups(User user, String[] unwanted) {
    user.groups.remove(unwanted);
    reportAll(user);
    loseUnwanted();
  }

  /** Removes those that nobody searches for any more. */
  @GuardedBy("this")
  private void loseUnwanted() {
    for (FoundRegistrar each : found.all()) {
      if (!isAnyWanted(each.groups)) {
        lose(each);
      }
    }
  }

  @GuardedBy("this")
  private void reportAll(User user) {
    if (users.contains(user)) { // else its search has ended
      found.all().forEach(each -> report(user, each));
    }
  }

  /** Reports to the users what has changed about a lookup service. */
  @GuardedBy("this")
  private void report(FoundRegistrar of) {
    users.forEach(user -> report(user, of));
  }

  @GuardedBy("this")
  private void report(User user, FoundRegistrar of) {
    LocatedRegistrar registrar = of.registrar;
    boolean isFound = found.contains(registrar) && user.groups.matchesAny(of.groups);
    if (isFound && user.reported.add(registrar)) {
      threads.timer().execute(() -> user.listener.found(registrar));
    } else if (!isFound && user.reported.remove(registrar)) {
      threads.timer().execute(() -> user.listener.lost(registrar));
    }
  }

  @GuardedBy("this")
  private boolean isAnyWanted(Collection<String> members) {
    return users.stream().anyMatch(each -> each.groups.matchesAny(members));
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
      if (known.isEmpty() && !isAnyWanted(members)) {
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
      if (!isAnyWanted(answer.groups())) {
        return false;
      }
    }
    LocatedRegistrar registrar = answer.registrar().prepared(settings.preparer());
    synchronized (this) {
      if (closed || !isAnyWanted(answer.groups()) || !found.isRoomFor(registrar)) {
        return false;
      }
      if (place != null) {
        hosts.succeeded(place, registrar);
      }
      report(found.add(registrar, host, answer.groups(), System.nanoTime()));
      return true;
    }
  }

  /** A user forgets a lookup service, which is searched for again. */
  void discard(User user, LocatedRegistrar registrar) {
    synchronized (this) {
      if (!user.reported.remove(registrar)) {
        return;
      }
      if (users.stream().noneMatch(each -> each.reported.contains(registrar))) {
        boolean unused = found.remove(registrar);
      }
      hosts.lost(registrar);
    }
    dispatch();
  }

  @GuardedBy("this")
  private void lose(FoundRegistrar lost) {
    if (found.remove(lost)) {
      hosts.lost(lost.registrar);
      report(lost);
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
        if (!closed && !isAnyWanted(actual)) {
          lose(which);
        } else if (!closed) {
          report(which);
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
  private void close() {
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
