package org.dfra.river.lease;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.rmi.RemoteException;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseMap;
import net.jini.core.lease.LeaseMapException;
import net.jini.core.lease.UnknownLeaseException;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.lease.LeaseRole;
import org.dfra.river.remote.LeaseRevokedException;
import org.dfra.river.server.Exporters;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The modules of a process share a landlord: one call renews a client's leases on all of them. */
@SuppressWarnings("unchecked") // River's maps have no types
class ProcessLandlordTest {

  private static final String HOST = "127.0.0.1";

  private final List<Grantor> modules = new ArrayList<>();

  private record Grantor(LeaseRegistry book, ModuleLandlord landlord) {
    Lease grant() throws Exception {
      return landlord.grant(10_000, LeaseRole.CLIENT, () -> {});
    }
  }

  private Grantor module(String name, String host) throws RemoteException {
    LeaseRegistry book =
        new LeaseRegistry(
            name, LeaseTerms.DEFAULT, InstantSource.system(), Scheduler.system(), clients -> {});
    ModuleLandlord landlord =
        new ModuleLandlord(
            name, book, ProcessLandlord.exporterAt(host, () -> Exporters.jeri(host, 2000)), host);
    landlord.start();
    Grantor made = new Grantor(book, landlord);
    modules.add(made);
    return made;
  }

  @AfterEach
  void close() {
    modules.forEach(each -> each.landlord().close());
    modules.forEach(each -> each.book().close());
  }

  @Test
  void oneCallRenewsLeasesOnAllModulesAndReportsEachFailureForItself() throws Exception {
    Grantor gps = module("atrv1/gps", HOST);
    Grantor laser = module("atrv1/laser", HOST);
    Lease first = gps.grant();
    Lease second = laser.grant();
    Lease cancelled = laser.grant();
    Lease revoked = gps.grant();
    assertThat(first.canBatch(second)).isTrue();
    cancelled.cancel();
    assertThat(gps.book().revoke(ModuleLandlord.id(revoked))).isTrue();
    LeaseMap all = first.createLeaseMap(20_000);
    for (Lease each : List.of(second, cancelled, revoked)) {
      all.put(each, 30_000L);
    }
    assertThatThrownBy(all::renewAll)
        .isInstanceOfSatisfying(
            LeaseMapException.class,
            e -> {
              assertThat(e.exceptionMap).hasSize(2);
              assertThat(e.exceptionMap.get(cancelled))
                  .isInstanceOf(UnknownLeaseException.class)
                  .hasToString(
                      "net.jini.core.lease.UnknownLeaseException: no module here knows such a"
                          + " lease; it has expired");
              assertThat(e.exceptionMap.get(revoked)).isInstanceOf(LeaseRevokedException.class);
            });
    assertThat(first.getExpiration() - System.currentTimeMillis()).isBetween(15_000L, 20_000L);
    assertThat(second.getExpiration() - System.currentTimeMillis()).isBetween(25_000L, 30_000L);
    assertThat(all).hasSize(2);
    all.cancelAll();
    assertThat(gps.book().clients()).isZero();
    assertThat(laser.book().clients()).isZero();
  }

  @Test
  void aModuleThatEndsTakesOnlyItsOwnLeasesWithIt() throws Exception {
    Grantor gps = module("atrv1/gps", HOST);
    Grantor laser = module("atrv1/laser", HOST);
    Lease first = gps.grant();
    Lease second = laser.grant();
    gps.landlord().close();
    assertThatThrownBy(() -> first.renew(10_000)).isInstanceOf(UnknownLeaseException.class);
    second.renew(20_000);
    laser.landlord().close();
    assertThatThrownBy(() -> second.renew(10_000))
        .as("the last module is gone, and so is the landlord")
        .isInstanceOf(RemoteException.class);
    Grantor again = module("atrv1/gps", HOST);
    Lease third = again.grant();
    third.renew(20_000);
    assertThatThrownBy(() -> first.renew(10_000)).isInstanceOf(RemoteException.class);
  }

  @Test
  void modulesThatListenAtAnotherAddressHaveAnotherLandlord() throws Exception {
    Lease first = module("atrv1/gps", HOST).grant();
    Lease other = module("atrv1/laser", "127.0.0.2").grant();
    assertThat(first.canBatch(other)).isFalse();
    first.renew(20_000);
    other.renew(20_000);
  }
}
