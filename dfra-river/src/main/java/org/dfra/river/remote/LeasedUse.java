package org.dfra.river.remote;

import java.io.Serializable;
import java.rmi.RemoteException;
import java.time.Instant;
import java.util.Objects;
import net.jini.core.lease.Lease;
import net.jini.core.lease.UnknownLeaseException;
import org.dfra.lease.ModuleLease;

/**
 * What a server gives to a client: its lease. It does not renew itself; the client's proxy does.
 *
 * @param lease counts its holder as a client unless it runs out
 */
public record LeasedUse(Lease lease) implements ModuleLease, Serializable {

  public LeasedUse {
    Objects.requireNonNull(lease, "lease");
  }

  @Override
  public Instant expiration() {
    return Instant.ofEpochMilli(lease.getExpiration());
  }

  @Override
  public boolean isLive() {
    return lease.getExpiration() > System.currentTimeMillis();
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
