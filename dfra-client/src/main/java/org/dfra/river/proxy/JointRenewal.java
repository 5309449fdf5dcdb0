package org.dfra.river.proxy;

import java.rmi.RemoteException;
import java.util.List;
import java.util.Map;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseException;
import net.jini.core.lease.LeaseMap;
import net.jini.core.lease.LeaseMapException;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/** One call that renews a lease, and others of the same landlord with it. */
final class JointRenewal {

  private JointRenewal() {}

  /** A lease that one call renews, perhaps with others; nobody else checks it meanwhile. */
  record DueLease(LeaseRenewer renewer, Lease lease, long duration) {}

  /**
   * Makes the call, and gives each renewer the result for its lease.
   *
   * @param together at least one
   * @param scheduler of the renewers
   */
  static void renew(List<DueLease> together, Scheduler scheduler) {
    DueLease first = together.get(0);
    long begun = scheduler.nanos();
    Map<?, ?> failed = Map.of();
    @Nullable Exception failure = new RemoteException("an error ended the renewal");
    try {
      if (together.size() == 1) {
        first.lease().renew(first.duration());
      } else {
        renewAll(together);
      }
      failure = null;
    } catch (LeaseMapException e) {
      failed = e.exceptionMap;
      failure = null;
    } catch (LeaseException | RemoteException | RuntimeException e) {
      failure = e;
    } finally {
      for (DueLease each : together) {
        each.renewer().tryConclude(each.lease(), begun, failure(each, failed, failure));
      }
    }
  }

  @SuppressWarnings("unchecked") // as River declares it
  private static void renewAll(List<DueLease> together) throws LeaseMapException, RemoteException {
    DueLease first = together.get(0);
    LeaseMap map = first.lease().createLeaseMap(first.duration());
    for (DueLease each : together.subList(1, together.size())) {
      map.put(each.lease(), each.duration());
    }
    map.renewAll();
  }

  private static @Nullable Exception failure(
      DueLease lease, Map<?, ?> failed, @Nullable Exception ofAll) {
    @Nullable Object own = failed.get(lease.lease());
    if (own == null) {
      return ofAll;
    }
    return own instanceof Exception known ? known : new RemoteException("not renewed: " + own);
  }
}
