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

/**
 * What a server gives to a client: its lease. It does not renew itself; the client's proxy does.
 */
public final class GrantedModuleLease implements ModuleLease, Serializable {

  /** Of the record that this was once. */
  @Serial private static final long serialVersionUID = 0;

  private final Lease lease;
  private final transient MonotonicLease span;

  /**
   * @param lease counts its holder as a client unless it runs out
   */
  public GrantedModuleLease(Lease lease) {
    this.lease = Objects.requireNonNull(lease, "lease");
    this.span = new MonotonicLease(lease);
  }

  /** For tests: by another time. */
  GrantedModuleLease(Lease lease, InstantSource clock, LongSupplier nanos) {
    this.lease = lease;
    this.span = new MonotonicLease(lease, clock, nanos);
  }

  /** Checks what has arrived, and turns the lease into a span of this computer's time. */
  @Serial
  private Object readResolve() {
    return new GrantedModuleLease(lease);
  }

  /** The lease, for who renews it. */
  public Lease lease() {
    return lease;
  }

  /** {@inheritDoc} For display: it goes by the wall clock. */
  @Override
  public Instant expiration() {
    return Instant.ofEpochMilli(lease.getExpiration());
  }

  @Override
  public boolean isLive() {
    return span.isLive();
  }

  /** {@inheritDoc} Where the server cannot be reached, it ends when it runs out. */
  @Override
  public void close() {
    try {
      lease.cancel();
    } catch (UnknownLeaseException | RemoteException e) {
      // it has ended, or will
    }
  }
}
