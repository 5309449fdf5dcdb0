package org.dfra.river.proxy;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import net.jini.core.lease.Lease;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.ModuleLease;
import org.dfra.river.remote.LeasedUse;
import org.dfra.river.remote.RemoteModule;
import org.dfra.time.Scheduler;

/** A client's lease on a module elsewhere, kept by a {@link Tenure}. */
final class ProxyLease implements ModuleLease {

  private final Tenure tenure;

  private ProxyLease(Tenure tenure) {
    this.tenure = tenure;
  }

  /** Asks for a lease, and keeps it. */
  static ProxyLease open(String path, RemoteModule server, Duration duration)
      throws LeaseRefusedException, RemoteException {
    Lease first = register(server, duration);
    Tenure tenure =
        new Tenure(
            "use of " + path,
            () -> register(server, duration),
            duration.toMillis(),
            first,
            Scheduler.system());
    tenure.start();
    return new ProxyLease(tenure);
  }

  private static Lease register(RemoteModule server, Duration duration)
      throws LeaseRefusedException, RemoteException {
    if (server.use(duration) instanceof LeasedUse leased) {
      return leased.lease();
    }
    throw new RemoteException("the server gave no lease for its use");
  }

  @Override
  public Instant expiration() {
    return tenure.expiration();
  }

  @Override
  public boolean isLive() {
    return tenure.isLive();
  }

  @Override
  public void close() {
    tenure.close();
  }
}
