package org.dfra.river.remote;

import com.sun.jini.landlord.Landlord;
import com.sun.jini.lease.AbstractLease;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.util.Objects;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseDeniedException;
import net.jini.core.lease.LeaseMap;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.id.ReferentUuid;
import net.jini.id.ReferentUuids;
import net.jini.id.Uuid;
import net.jini.security.proxytrust.TrustEquivalence;
import org.jspecify.annotations.Nullable;

/**
 * A lease of a landlord: leases of the same landlord can be renewed in one call. All modules of a
 * process share a landlord.
 *
 * <p>River's own {@code LandlordLease} compares the landlords' IDs, which a landlord chooses. A
 * client that holds a lease of a dishonest landlord would send it the IDs of its leases elsewhere,
 * with which anybody can cancel them. Here, two leases have the same landlord only if their proxies
 * lead to the same object by the same way.
 */
public final class ProcessLease extends AbstractLease implements ReferentUuid {

  @Serial private static final long serialVersionUID = 1;

  /** The lease's ID: a secret of its holder and the landlord. */
  private final Uuid cookie;

  private final Landlord landlord;

  /**
   * @param cookie its ID
   * @param landlord renews and cancels it
   * @param expiration its end, milliseconds of this computer's clock
   */
  public ProcessLease(Uuid cookie, Landlord landlord, long expiration) {
    super(expiration);
    this.cookie = Objects.requireNonNull(cookie, "cookie");
    this.landlord = Objects.requireNonNull(landlord, "landlord");
  }

  @Override
  public Uuid getReferentUuid() {
    return cookie;
  }

  @Override
  protected long doRenew(long duration)
      throws UnknownLeaseException, LeaseDeniedException, RemoteException {
    return landlord.renew(cookie, duration);
  }

  @Override
  public void cancel() throws UnknownLeaseException, RemoteException {
    landlord.cancel(cookie);
  }

  @Override
  public boolean canBatch(Lease lease) {
    return lease instanceof ProcessLease other && isSame(landlord, other.landlord);
  }

  private static boolean isSame(Landlord one, Landlord other) {
    if (one == other) {
      return true;
    }
    @Nullable TrustEquivalence handler = handler(one);
    @Nullable TrustEquivalence second = handler(other);
    return handler != null
        && second != null
        && handler.checkTrustEquivalence(second)
        && second.checkTrustEquivalence(handler);
  }

  private static @Nullable TrustEquivalence handler(Landlord landlord) {
    if (!Proxy.isProxyClass(landlord.getClass())) {
      return null;
    }
    InvocationHandler handler = Proxy.getInvocationHandler(landlord);
    return handler instanceof TrustEquivalence comparable ? comparable : null;
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public LeaseMap createLeaseMap(long duration) {
    return new ProcessLeaseMap(this, duration);
  }

  /**
   * The same lease, whose landlord must meet the constraints of the proxy through which it was
   * received: only the same robot's processes may renew and cancel it.
   *
   * @param constraints of that proxy; null for none
   * @throws RemoteException if the landlord's proxy takes no constraints
   */
  public ProcessLease constrained(@Nullable MethodConstraints constraints) throws RemoteException {
    if (constraints == null) {
      return this;
    } else if (landlord instanceof RemoteMethodControl control) {
      return new ProcessLease(
          cookie, (Landlord) control.setConstraints(constraints), getExpiration());
    }
    throw new RemoteException("a lease whose landlord nobody can authenticate");
  }

  Landlord landlord() {
    return landlord;
  }

  /** Sets the end after a renewal, milliseconds of this computer's clock. */
  synchronized void extendTo(long end) {
    expiration = end;
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return ReferentUuids.compare(this, other);
  }

  @Override
  public int hashCode() {
    return cookie.hashCode();
  }

  /** Without the ID, which is a secret. */
  @Override
  public String toString() {
    return "a lease until " + java.time.Instant.ofEpochMilli(getExpiration());
  }

  @Serial
  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    if (cookie == null || landlord == null) {
      throw new InvalidObjectException("a lease without ID or landlord");
    }
  }
}
