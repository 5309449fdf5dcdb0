package org.dfra.river.remote;

import java.io.Serial;
import java.io.Serializable;
import java.rmi.RemoteException;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Objects;
import java.util.function.LongSupplier;
import net.jini.core.lease.Lease;
import net.jini.core.lease.UnknownLeaseException;
import org.dfra.lease.ModuleLease;

/** A lease as a server grants it to a client. It does not renew itself; the client's proxy does. */
public final class GrantedModuleLease implements ModuleLease, Serializable {

  /** The serial form of the former record. */
  @Serial private static final long serialVersionUID = 0;

  private final Lease lease;
  private final transient MonotonicLease span;

  /**
   * @param lease its holder counts as a client until it expires
   */
  public GrantedModuleLease(Lease lease) {
    this.lease = Objects.requireNonNull(lease, "lease");
    this.span = new MonotonicLease(lease);
  }

  /** For tests, with another clock. */
  GrantedModuleLease(Lease lease, InstantSource clock, LongSupplier nanos) {
    this.lease = lease;
    this.span = new MonotonicLease(lease, clock, nanos);
  }

  /** Validates the received data, and converts the lease to a duration on this computer. */
  @Serial
  private Object readResolve() {
    return new GrantedModuleLease(lease);
  }

  /** The lease, for its renewal. */
  public Lease lease() {
    return lease;
  }

  /** {@inheritDoc} For display: it uses the wall clock. */
  @Override
  public Instant expiration() {
    return Instant.ofEpochMilli(lease.getExpiration());
  }

  @Override
  public boolean isLive() {
    return span.isLive();
  }

  /** {@inheritDoc} If the server cannot be reached, the lease ends when it expires. */
  @Override
  public void close() {
    try {
      lease.cancel();
    } catch (UnknownLeaseException | RemoteException e) {
      // it has ended, or will expire
    }
  }
}
