package org.dfra.river.lease;

import com.sun.jini.landlord.FixedLeasePeriodPolicy;
import com.sun.jini.landlord.Landlord;
import com.sun.jini.landlord.LandlordUtil;
import com.sun.jini.landlord.LeaseFactory;
import com.sun.jini.landlord.LeasePeriodPolicy;
import com.sun.jini.landlord.LeasedResource;
import com.sun.jini.landlord.LocalLandlord;
import java.math.BigDecimal;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseDeniedException;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.export.Exporter;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import org.jspecify.annotations.Nullable;

/**
 * Grants leases on the use of one module, and counts its clients by them.
 *
 * <p>Entries of component {@value #COMPONENT} in the module's Jini configuration: {@code
 * longestLease} and {@code defaultLease}, in milliseconds.
 */
public final class ModuleLandlord implements Landlord, LocalLandlord, AutoCloseable {

  private static final String COMPONENT = "org.dfra.river.lease";

  private final String module;
  private final long longest;
  private final LeasePeriodPolicy policy;
  private final Exporter exporter;
  private final Map<Uuid, Client> clients = new ConcurrentHashMap<>();
  private volatile @Nullable LeaseFactory factory;

  /**
   * @param module the module's path, {@code robot/name}
   * @param configuration the module's Jini configuration
   * @param exporter exports the landlord while it is started
   * @throws ConfigurationException if a lease is set to less than a millisecond, or the usual one
   *     is longer than the longest
   */
  public ModuleLandlord(String module, Configuration configuration, Exporter exporter)
      throws ConfigurationException {
    this.module = module;
    this.exporter = exporter;
    this.longest = millis(configuration, "longestLease", Duration.ofSeconds(30));
    long usual = millis(configuration, "defaultLease", Duration.ofMillis(longest / 3));
    if (usual > longest) {
      throw new ConfigurationException(
          COMPONENT + ": defaultLease " + usual + " ms > longestLease " + longest + " ms");
    }
    this.policy = new FixedLeasePeriodPolicy(longest, usual);
  }

  private static long millis(Configuration configuration, String entry, Duration fallback)
      throws ConfigurationException {
    long millis = (Long) configuration.getEntry(COMPONENT, entry, long.class, fallback.toMillis());
    if (millis < 1) {
      throw new ConfigurationException(COMPONENT + "." + entry + " = " + millis + " ms < 1 ms");
    }
    return millis;
  }

  /** Exports the landlord. Before this it grants nothing. */
  public void start() throws RemoteException {
    if (factory == null) {
      factory = new LeaseFactory((Landlord) exporter.export(this), UuidFactory.generate());
    }
  }

  /** Ends every lease. */
  @Override
  public void close() {
    if (factory != null) {
      factory = null;
      exporter.unexport(true);
      clients.clear();
    }
  }

  /**
   * Grants a lease.
   *
   * @param duration how long, in milliseconds; {@link Lease#ANY} for the module's choice
   * @throws LeaseDeniedException if it is longer than allowed or the landlord is not started
   */
  public Lease grant(long duration) throws LeaseDeniedException {
    check(duration);
    @Nullable LeaseFactory open = factory;
    if (open == null) {
      throw new LeaseDeniedException(module + " grants no leases now; it starts or stops");
    }
    prune();
    Client client = new Client(UuidFactory.generate());
    LeasePeriodPolicy.Result granted = policy.grant(client, duration);
    client.setExpiration(granted.expiration);
    clients.put(client.getCookie(), client);
    return open.newLease(client.getCookie(), granted.expiration);
  }

  /** How many clients hold a lease now. */
  public int clients() {
    prune();
    return clients.size();
  }

  private void prune() {
    long now = System.currentTimeMillis();
    clients.values().removeIf(client -> client.getExpiration() <= now);
  }

  private void check(long duration) throws LeaseDeniedException {
    if (duration != Lease.ANY && (duration < 1 || duration > longest)) {
      throw new LeaseDeniedException(
          module
              + ": lease "
              + (duration == Lease.FOREVER ? "for ever" : seconds(duration))
              + (duration < 1 ? " is not above 0" : " > longest allowed " + seconds(longest))
              + "; ask for "
              + seconds(longest)
              + " or less");
    }
  }

  /** 30 s rather than 30.0 s. */
  private static String seconds(long millis) {
    return BigDecimal.valueOf(millis, 3).stripTrailingZeros().toPlainString() + " s";
  }

  @Override
  public long renew(Uuid cookie, long duration) throws LeaseDeniedException, UnknownLeaseException {
    check(duration);
    prune();
    Client client = clients.get(cookie);
    if (client == null) {
      throw new UnknownLeaseException(module + " knows no such lease; it has expired");
    }
    LeasePeriodPolicy.Result granted = policy.renew(client, duration);
    client.setExpiration(granted.expiration);
    return granted.duration;
  }

  @Override
  public void cancel(Uuid cookie) throws UnknownLeaseException {
    if (clients.remove(Objects.requireNonNull(cookie)) == null) {
      throw new UnknownLeaseException(module + " knows no such lease; it has expired");
    }
  }

  @Override
  public RenewResults renewAll(Uuid[] cookies, long[] durations) {
    return LandlordUtil.renewAll(this, cookies, durations);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public @Nullable Map cancelAll(Uuid[] cookies) {
    return LandlordUtil.cancelAll(this, cookies);
  }

  /** One client, as the landlord's policy sees it. */
  private static final class Client implements LeasedResource {
    private final Uuid cookie;
    private volatile long expiration;

    Client(Uuid cookie) {
      this.cookie = cookie;
    }

    @Override
    public void setExpiration(long next) {
      expiration = next;
    }

    @Override
    public long getExpiration() {
      return expiration;
    }

    @Override
    public Uuid getCookie() {
      return cookie;
    }
  }
}
