package org.dfra.river.lease;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import com.sun.jini.landlord.Landlord;
import com.sun.jini.landlord.LandlordUtil;
import com.sun.jini.landlord.LocalLandlord;
import java.net.InetAddress;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseDeniedException;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.export.Exporter;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.lease.LeaseRegistry.LeaseGrant;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.river.access.RemoteCaller;
import org.dfra.river.callback.ClientAddress;
import org.dfra.river.callback.PeerQuota;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.remote.LeaseRevokedException;
import org.dfra.river.remote.ProcessLease;
import org.dfra.security.Permissions;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Grants the leases of a module's {@link LeaseRegistry} to remote clients: a River landlord that
 * stores its leases in that registry.
 *
 * <p>Entries of component {@value #COMPONENT} in the module's Jini configuration: {@code
 * longestLease} and {@code defaultLease}, in milliseconds.
 */
public final class ModuleLandlord implements Landlord, LocalLandlord, AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(ModuleLandlord.class);

  private static final String COMPONENT = "org.dfra.river.lease";

  /** Above the limit of listeners, each of which holds one. */
  private static final PeerQuota.QuotaLimits LIMITS = new PeerQuota.QuotaLimits(256, 1024, 4096);

  /** Maximum number of leases that are renewed or cancelled in one call. */
  static final int MAX_LEASES_PER_CALL = 1024;

  private final String module;
  private final LeaseRegistry book;
  private final Exporter exporter;
  private final String host;
  private final PeerQuota quota;
  private volatile @Nullable Landlord proxy; // once it is exported
  private volatile Runnable notWatching = () -> {}; // ends the callback of endLost
  private volatile Permissions permissions = Permissions.LASTING; // from the start on

  /** Who holds leases: one that is revoked, or that a new policy does not permit, ends at once. */
  private final Map<UUID, LeaseHolder> holders = new ConcurrentHashMap<>();

  /**
   * @param module the module's path, {@code robot/name}
   * @param book the registry of its leases
   * @param exporter exports the landlord while it is started
   * @param host address or name that the module's proxies carry: clients at that address are on
   *     this computer
   */
  public ModuleLandlord(String module, LeaseRegistry book, Exporter exporter, String host) {
    this.module = module;
    this.book = book;
    this.exporter = exporter;
    this.host = host;
    this.quota = new PeerQuota("leases on " + module, LIMITS);
  }

  /**
   * Reads the lease terms of a module's Jini configuration.
   *
   * @throws ConfigurationException if a lease is set to less than a millisecond, or the default one
   *     is longer than the longest
   */
  public static LeaseTerms terms(Configuration configuration) throws ConfigurationException {
    long longest =
        millis(configuration, "longestLease", LeaseTerms.DEFAULT.maxDuration().toMillis());
    long usual = millis(configuration, "defaultLease", Math.max(1, longest / 3));
    if (usual > longest) {
      throw new ConfigurationException(
          COMPONENT + ": defaultLease " + usual + " ms > longestLease " + longest + " ms");
    }
    return new LeaseTerms(Duration.ofMillis(longest), Duration.ofMillis(usual));
  }

  private static long millis(Configuration configuration, String entry, long fallback)
      throws ConfigurationException {
    long millis = (Long) configuration.getEntry(COMPONENT, entry, long.class, fallback);
    if (millis < 1) {
      throw new ConfigurationException(COMPONENT + "." + entry + " = " + millis + " ms < 1 ms");
    }
    return millis;
  }

  /** Exports the landlord. Before that it grants nothing. */
  public void start() throws RemoteException {
    if (proxy == null) {
      permissions = LeaseHolder.currentPermissions();
      notWatching = CurrentIdentity.onLostRights(this::endLost);
      proxy = (Landlord) exporter.export(this);
    }
  }

  /** Stops granting and renewing leases. The registry is unchanged; its owner closes it. */
  @Override
  public void close() {
    if (proxy != null) {
      proxy = null;
      exporter.unexport(true);
    }
    notWatching.run();
  }

  private void endLost() {
    holders.forEach(this::endIfLost);
  }

  /**
   * Ends a lease whose holder has lost its right: what it commands must not go on until the lease
   * expires. After a new policy, it may ask for another one, since a later one may permit it again.
   */
  private void endIfLost(UUID id, LeaseHolder holder) {
    if (holder.isRevoked()) {
      LOG.info("{}: a lease of {} ends, whose certificate was revoked", module, holder);
      book.revokeInBackground(id);
    } else if (!holder.isStillPermitted(permissions)) {
      LOG.info("{}: a lease of {} ends, which the policy no longer permits", module, holder);
      book.expireInBackground(id);
    }
  }

  /**
   * Grants a lease to the client of the remote call that runs on this thread.
   *
   * @param duration in milliseconds; {@link Lease#ANY} for the module's default
   * @param onExpired runs once when it has expired or was revoked
   * @throws LeaseRefusedException if it is longer than allowed, not above zero, the landlord is not
   *     started, or the client has reached its limit. A commander's lease is not counted: there is
   *     one at most
   */
  public Lease grant(long duration, LeaseRole holder, Runnable onExpired)
      throws LeaseRefusedException {
    return grant(duration, holder, onExpired, () -> {});
  }

  /**
   * As {@link #grant(long, LeaseRole, Runnable)}, with a callback for cancellation.
   *
   * @param onCancelled runs once when its holder cancels it
   */
  public Lease grant(long duration, LeaseRole holder, Runnable onExpired, Runnable onCancelled)
      throws LeaseRefusedException {
    @Nullable Landlord open = proxy;
    if (open == null) {
      throw new LeaseRefusedException(module + " grants no leases now; it starts or stops");
    }
    Holding holding = new Holding();
    Runnable expired = () -> runBoth(holding::end, onExpired);
    Runnable cancelled = () -> runBoth(holding::end, onCancelled);
    LeaseGrant granted =
        holder == LeaseRole.COMMANDER
            ? book.grant(requestedDuration(duration), holder, clientHost(), expired, cancelled)
            : counted(requestedDuration(duration), holder, expired, cancelled);
    UUID id = granted.id();
    holding.begin(id, LeaseHolder.ofCurrentCall(holder));
    return new ProcessLease(
        UuidFactory.create(id.getMostSignificantBits(), id.getLeastSignificantBits()),
        open,
        System.currentTimeMillis() + granted.duration().toMillis());
  }

  /** A lease among those of {@link #holders}, if its connection is not open. */
  private final class Holding {

    @GuardedBy("this")
    private boolean isOver;

    @GuardedBy("this")
    private @Nullable UUID id;

    void begin(UUID granted, Optional<LeaseHolder> holder) {
      if (holder.isEmpty()) {
        return;
      }
      synchronized (this) {
        if (isOver) {
          return;
        }
        id = granted;
        holders.put(granted, holder.get());
      }
      endIfLost(granted, holder.get()); // since its call was permitted
    }

    synchronized void end() {
      isOver = true;
      if (id != null) {
        holders.remove(id);
      }
    }
  }

  private LeaseGrant counted(
      Duration asked, LeaseRole holder, Runnable whenOver, Runnable whenCancelled)
      throws LeaseRefusedException {
    ClientAddress client = ClientAddress.ofCurrentCall(host);
    Optional<String> refusal = quota.acquire(client);
    if (refusal.isPresent()) {
      throw new LeaseRefusedException(refusal.get());
    }
    AtomicBoolean isHeld = new AtomicBoolean(true);
    Runnable ended =
        () -> {
          if (isHeld.compareAndSet(true, false)) {
            quota.release(client);
          }
        };
    boolean isGranted = false;
    try {
      LeaseGrant granted =
          book.grant(
              asked,
              holder,
              clientHost(),
              () -> runBoth(ended, whenOver),
              () -> runBoth(ended, whenCancelled));
      isGranted = true;
      return granted;
    } finally {
      if (!isGranted) {
        ended.run();
      }
    }
  }

  private static void runBoth(Runnable first, Runnable second) {
    first.run();
    second.run();
  }

  /**
   * The address of the client of the call that runs on this thread; null if its transport does not
   * report it.
   */
  public static @Nullable String clientHost() {
    return RemoteCaller.current()
        .map(RemoteCaller::address)
        .map(InetAddress::getHostAddress)
        .orElse(null);
  }

  private Duration requestedDuration(long millis) {
    return millis == Lease.ANY ? book.terms().defaultDuration() : Duration.ofMillis(millis);
  }

  /** Whether a lease is one of this module's, or was until it was revoked. */
  boolean knows(Uuid cookie) {
    UUID id = id(cookie);
    return book.contains(id) || book.isRevoked(id);
  }

  @Override
  public long renew(Uuid cookie, long duration) throws LeaseDeniedException, UnknownLeaseException {
    if (book.isRevoked(id(cookie))) {
      throw new LeaseRevokedException(module + ": an administrator has revoked this lease");
    }
    @Nullable LeaseHolder holder = holders.get(id(cookie));
    if (holder != null && holder.isRevoked()) { // such as a delegation that has expired
      book.revokeInBackground(id(cookie));
      throw new LeaseDeniedException(
          module + ": " + holder + " no longer has the right with which it acquired this lease");
    }
    try {
      Optional<LeaseGrant> granted = book.renew(id(cookie), requestedDuration(duration));
      return granted
          .orElseThrow(() -> new UnknownLeaseException(module + NO_SUCH_LEASE))
          .duration()
          .toMillis();
    } catch (LeaseRefusedException e) {
      throw new LeaseDeniedException(e.getMessage());
    }
  }

  @Override
  public void cancel(Uuid cookie) throws UnknownLeaseException {
    if (!book.cancel(id(cookie))) {
      throw new UnknownLeaseException(module + NO_SUCH_LEASE);
    }
  }

  private static final String NO_SUCH_LEASE = " knows no such lease; it has expired";

  private static UUID id(Uuid cookie) {
    return new UUID(cookie.getMostSignificantBits(), cookie.getLeastSignificantBits());
  }

  /** The ID of a lease in the module's {@link LeaseRegistry}: a secret of its holder. */
  public static UUID id(Lease lease) {
    return id(((net.jini.id.ReferentUuid) lease).getReferentUuid());
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException if they are more than {@value #MAX_LEASES_PER_CALL}
   */
  @Override
  public RenewResults renewAll(Uuid[] cookies, long[] durations) {
    checkCount(module, cookies);
    return LandlordUtil.renewAll(this, cookies, durations);
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException if they are more than {@value #MAX_LEASES_PER_CALL}
   */
  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public @Nullable Map cancelAll(Uuid[] cookies) {
    checkCount(module, cookies);
    return LandlordUtil.cancelAll(this, cookies);
  }

  /** Each unknown lease costs an exception with its stack trace, also in the response. */
  static void checkCount(String grantor, Uuid[] cookies) {
    if (cookies.length > MAX_LEASES_PER_CALL) {
      throw new IllegalArgumentException(
          grantor
              + ": "
              + cookies.length
              + " leases in one call > "
              + MAX_LEASES_PER_CALL
              + " allowed; name fewer");
    }
  }
}
