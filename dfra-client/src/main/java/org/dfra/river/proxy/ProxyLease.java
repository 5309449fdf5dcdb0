package org.dfra.river.proxy;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import net.jini.core.lease.Lease;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.ModuleLease;
import org.dfra.river.remote.GrantedModuleLease;
import org.dfra.river.remote.RemoteModule;
import org.dfra.time.Scheduler;

/** A client's lease on a remote module, maintained by a {@link LeaseRenewer}. */
final class ProxyLease implements ModuleLease {

  private final LeaseRenewer renewer;

  private ProxyLease(LeaseRenewer renewer) {
    this.renewer = renewer;
  }

  /** Requests a lease, and maintains it. */
  static ProxyLease open(String path, RemoteModule server, Duration duration)
      throws LeaseRefusedException, RemoteException {
    long asked = Scheduler.system().nanos();
    Lease first = register(server, duration);
    LeaseRenewer renewer =
        new LeaseRenewer(
            "use of " + path,
            () -> register(server, duration),
            duration.toMillis(),
            first,
            Scheduler.system());
    renewer.requestedAt(asked).start();
    return new ProxyLease(renewer);
  }

  private static Lease register(RemoteModule server, Duration duration)
      throws LeaseRefusedException, RemoteException {
    if (server.acquireLease(duration) instanceof GrantedModuleLease leased) {
      return PreparedProxies.lease(server, leased.lease());
    }
    throw new RemoteException("the server gave no lease for its use");
  }

  @Override
  public Instant expiration() {
    return renewer.expiration();
  }

  @Override
  public boolean isLive() {
    return renewer.isLive();
  }

  @Override
  public void close() {
    renewer.close();
  }
}
