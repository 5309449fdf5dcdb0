package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import com.sun.jini.landlord.Landlord;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.config.ConfigurationException;
import net.jini.config.EmptyConfiguration;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseDeniedException;
import net.jini.core.lease.LeaseMap;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.lease.LeaseListener;
import net.jini.lease.LeaseRenewalEvent;
import net.jini.lease.LeaseRenewalManager;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.example.thermometer.RemoteThermometer;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.lookup.SuppliedConfiguration;
import org.dfra.river.remote.GrantedModuleLease;
import org.dfra.river.remote.ProcessLease;
import org.dfra.river.server.Exporters;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ModuleLandlordTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private LeaseRegistry book;
  private ModuleLandlord landlord;

  @BeforeEach
  void make() throws ConfigurationException {
    book = book(ModuleLandlord.terms(EmptyConfiguration.INSTANCE));
    landlord =
        new ModuleLandlord(
            "atrv1/gps", book, Exporters.jeri(EmbeddedReggie.HOST, 2000), EmbeddedReggie.HOST);
  }

  private static LeaseRegistry book(LeaseTerms terms) {
    return new LeaseRegistry(
        "atrv1/gps", terms, InstantSource.system(), Scheduler.system(), clients -> {});
  }

  private Lease grant(long millis) throws LeaseRefusedException {
    return landlord.grant(millis, LeaseRole.CLIENT, () -> {});
  }

  @AfterEach
  void end() {
    landlord.close();
  }

  @Test
  void countsAClientFromGrantToCancel() throws Exception {
    landlord.start();
    landlord.start();
    Lease first = grant(10_000);
    Lease second = grant(10_000);
    assertThat(book.clients()).isEqualTo(2);
    assertThat(first.getExpiration() - System.currentTimeMillis())
        .isCloseTo(10_000L, within(1_000L));
    first.cancel();
    assertThat(book.clients()).isEqualTo(1);
    assertThatThrownBy(first::cancel)
        .isInstanceOf(UnknownLeaseException.class)
        .hasMessage("atrv1/gps knows no such lease; it has expired");
    second.cancel();
    assertThat(book.clients()).isZero();
  }

  @Test
  void renewsALeaseBeforeItExpires() throws Exception {
    landlord.start();
    Lease lease = grant(2_000);
    lease.renew(30_000);
    assertThat(lease.getExpiration() - System.currentTimeMillis())
        .isCloseTo(30_000L, within(1_000L));
    assertThatThrownBy(() -> lease.renew(120_000))
        .isInstanceOf(LeaseDeniedException.class)
        .hasMessageContaining("lease 120 s > longest allowed 30 s");
    assertThat(book.clients()).as("a renewal refused ends no lease").isEqualTo(1);
  }

  @Test
  void oneCallNamesOnlySoManyLeases() throws Exception {
    landlord.start();
    Uuid[] many = new Uuid[1025];
    Arrays.fill(many, UuidFactory.generate());
    for (ThrowingCallable call :
        List.<ThrowingCallable>of(
            () -> landlord.renewAll(many, new long[many.length]), () -> landlord.cancelAll(many))) {
      assertThatThrownBy(call)
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("atrv1/gps: 1025 leases in one call > 1024 allowed; name fewer");
    }
    assertThat((Map<?, ?>) landlord.cancelAll(Arrays.copyOf(many, 1024))).hasSize(1);
  }

  @Test
  void forgetsAClientWhoseLeaseRanOut() throws Exception {
    landlord.start();
    Lease lease = grant(20);
    await().atMost(PATIENCE).until(() -> book.clients() == 0);
    assertThatThrownBy(() -> lease.renew(1_000))
        .isInstanceOf(UnknownLeaseException.class)
        .hasMessage("atrv1/gps knows no such lease; it has expired");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "120000 | atrv1/gps: lease 120 s > longest allowed 30 s; ask for 30 s or less",
        "30001 | atrv1/gps: lease 30.001 s > longest allowed 30 s; ask for 30 s or less",
        "0 | atrv1/gps: lease 0 s is not above 0; ask for 30 s or less",
        "-5000 | atrv1/gps: lease -5 s is not above 0; ask for 30 s or less",
        "9223372036854775807"
            + "| atrv1/gps: lease for ever > longest allowed 30 s; ask for 30 s or less",
      })
  void refusesALeaseItDoesNotGrant(long millis, String sentence) throws Exception {
    landlord.start();
    assertThatThrownBy(() -> grant(millis))
        .isInstanceOf(LeaseRefusedException.class)
        .hasMessage(sentence);
    assertThat(book.clients()).isZero();
  }

  @Test
  void grantsItsOwnChoiceToWhoWantsAny() throws Exception {
    landlord.start();
    Lease lease = grant(Lease.ANY);
    assertThat(lease.getExpiration() - System.currentTimeMillis())
        .as("a third of the longest")
        .isCloseTo(10_000L, within(1_000L));
    assertThat(grant(30_000).getExpiration()).isGreaterThan(lease.getExpiration());
  }

  @Test
  void grantsNothingBeforeStartAndAfterClose() throws Exception {
    assertThatThrownBy(() -> grant(1_000))
        .isInstanceOf(LeaseRefusedException.class)
        .hasMessage("atrv1/gps grants no leases now; it starts or stops");
    landlord.start();
    Lease lease = grant(10_000);
    landlord.close();
    landlord.close();
    assertThatThrownBy(() -> grant(1_000)).isInstanceOf(LeaseRefusedException.class);
    assertThatThrownBy(() -> lease.renew(1_000)).isInstanceOf(java.rmi.RemoteException.class);
  }

  @Test
  void renewsAndCancelsManyAtOnceAndReportsWhichFailed() throws Exception {
    landlord.start();
    ProcessLease good = (ProcessLease) grant(5_000);
    ProcessLease other = (ProcessLease) grant(5_000);
    Uuid unknown = UuidFactory.generate();
    Landlord.RenewResults renewed =
        landlord.renewAll(
            new Uuid[] {good.getReferentUuid(), unknown, other.getReferentUuid()},
            new long[] {20_000, 20_000, 120_000});
    assertThat(renewed.granted).containsExactly(20_000, -1, -1);
    assertThat(renewed.denied)
        .hasSize(2)
        .hasAtLeastOneElementOfType(UnknownLeaseException.class)
        .hasAtLeastOneElementOfType(LeaseDeniedException.class);

    LeaseMap both = good.createLeaseMap(10_000);
    assertThat(both.canContainKey(other)).as("leases of one landlord batch").isTrue();

    Map<?, ?> failed =
        landlord.cancelAll(new Uuid[] {good.getReferentUuid(), unknown, other.getReferentUuid()});
    assertThat(failed).hasSize(1);
    assertThat(failed.get(unknown)).isInstanceOf(UnknownLeaseException.class);
    assertThat(book.clients()).isZero();
    assertThat(landlord.cancelAll(new Uuid[0])).isNull();
  }

  @Test
  void takesItsTermsFromTheConfiguration() throws Exception {
    LeaseTerms strict = terms(500L, 100L);
    assertThat(strict).isEqualTo(new LeaseTerms(Duration.ofMillis(500), Duration.ofMillis(100)));
    assertThatThrownBy(
            () -> book(strict).grant(Duration.ofMillis(501), LeaseRole.CLIENT, null, () -> {}))
        .hasMessageContaining("lease 0.501 s > longest allowed 0.5 s");
    assertThatThrownBy(() -> terms(0L, 0L))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("longestLease = 0 ms < 1 ms");
    assertThatThrownBy(() -> terms(10L, 11L))
        .hasMessageContaining("defaultLease 11 ms > longestLease 10 ms");
  }

  private static LeaseTerms terms(long longest, long usual) throws ConfigurationException {
    return ModuleLandlord.terms(
        new SuppliedConfiguration(
            Map.of(
                "org.dfra.river.lease.longestLease", () -> longest,
                "org.dfra.river.lease.defaultLease", () -> usual)));
  }

  @Test
  void aRemoteClientKeepsItsLeaseByRiversRenewalManager() throws Exception {
    ServedModule<ThermometerServer> module =
        ServedModule.of(
            ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class);
    try (ThermometerServer server = module.serve()) {
      RemoteThermometer remote = (RemoteThermometer) server.getProxy();
      assertThatThrownBy(() -> remote.acquireLease(Duration.ofMinutes(2)))
          .as("the sentence crosses the wire")
          .isInstanceOf(LeaseRefusedException.class)
          .hasMessageContaining("lease 120 s > longest allowed 30 s");
      Lease lease = ((GrantedModuleLease) remote.acquireLease(Duration.ofSeconds(10))).lease();
      long granted = lease.getExpiration();
      AtomicReference<LeaseRenewalEvent> failure = new AtomicReference<>();
      LeaseListener listener = failure::set;
      LeaseRenewalManager manager =
          new LeaseRenewalManager(
              new SuppliedConfiguration(
                  Map.of("net.jini.lease.LeaseRenewalManager.roundTripTime", () -> 9_500L)));
      manager.renewUntil(lease, Lease.FOREVER, 10_000, listener); // after half a second
      await().atMost(PATIENCE).until(() -> lease.getExpiration() > granted + 400);
      assertThat(failure.get()).as("a renewal that failed").isNull();
      manager.cancel(lease);
      assertThatThrownBy(lease::cancel).isInstanceOf(UnknownLeaseException.class);
    }
  }
}
