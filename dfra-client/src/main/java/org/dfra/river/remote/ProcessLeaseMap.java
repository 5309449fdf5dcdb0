package org.dfra.river.remote;

import com.sun.jini.landlord.Landlord;
import com.sun.jini.lease.AbstractLeaseMap;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import net.jini.core.lease.LeaseMapException;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.id.Uuid;
import org.jspecify.annotations.Nullable;

/** Leases of one landlord, which are renewed or cancelled by one call. Not thread-safe. */
@SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
final class ProcessLeaseMap extends AbstractLeaseMap {

  private final ProcessLease first;

  ProcessLeaseMap(ProcessLease first, long duration) {
    super(first, duration);
    this.first = first;
  }

  @Override
  public boolean canContainKey(Object key) {
    return key instanceof ProcessLease lease && first.canBatch(lease);
  }

  private List<ProcessLease> leases() {
    return new ArrayList<>(((Map<ProcessLease, Long>) map).keySet());
  }

  private static Uuid[] cookies(List<ProcessLease> leases) {
    return leases.stream().map(ProcessLease::getReferentUuid).toArray(Uuid[]::new);
  }

  /**
   * {@inheritDoc}
   *
   * @throws LeaseMapException with the exception of each lease that was not renewed; they are
   *     removed from this map
   */
  @Override
  public void renewAll() throws LeaseMapException, RemoteException {
    List<ProcessLease> leases = leases();
    long[] durations = leases.stream().mapToLong(each -> (Long) map.get(each)).toArray();
    Landlord.RenewResults results = first.landlord().renewAll(cookies(leases), durations);
    if (results == null || results.granted == null || results.granted.length != leases.size()) {
      throw new RemoteException("the landlord's answer does not fit the leases that it renewed");
    }
    long now = System.currentTimeMillis();
    Map<ProcessLease, Throwable> failed = new HashMap<>();
    int denied = 0;
    for (int i = 0; i < leases.size(); i++) {
      long granted = results.granted[i];
      if (granted == -1) {
        failed.put(leases.get(i), reason(results.denied, denied++));
      } else {
        long end = now + granted;
        leases.get(i).extendTo(end < 0 && granted > 0 ? Long.MAX_VALUE : end);
      }
    }
    throwIfAny(failed, "leases were not renewed");
  }

  private static Throwable reason(Exception @Nullable [] denied, int index) {
    return denied != null && index < denied.length && denied[index] != null
        ? denied[index]
        : new UnknownLeaseException("the landlord did not renew the lease and gave no reason");
  }

  /**
   * {@inheritDoc}
   *
   * @throws LeaseMapException with the exception of each lease that was not cancelled; they are
   *     removed from this map
   */
  @Override
  public void cancelAll() throws LeaseMapException, RemoteException {
    List<ProcessLease> leases = leases();
    @Nullable Map<Uuid, Exception> denied = first.landlord().cancelAll(cookies(leases));
    Map<ProcessLease, Throwable> failed = new HashMap<>();
    for (ProcessLease each : leases) {
      @Nullable Exception reason = denied == null ? null : denied.get(each.getReferentUuid());
      if (reason != null) {
        failed.put(each, reason);
      }
    }
    throwIfAny(failed, "leases were not cancelled");
  }

  private void throwIfAny(Map<ProcessLease, Throwable> failed, String what)
      throws LeaseMapException {
    if (!failed.isEmpty()) {
      failed.keySet().forEach(map::remove);
      throw new LeaseMapException(failed.size() + " " + what, failed);
    }
  }
}
