package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import com.sun.jini.landlord.Landlord;
import com.sun.jini.landlord.LandlordLease;
import java.time.Duration;
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
import org.dfra.example.thermometer.RemoteThermometer;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.lookup.SuppliedConfiguration;
import org.dfra.river.server.Exporters;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ModuleLandlordTest {

  private static final Duration PATIENCE = Duration.ofSeconds(5);

  private ModuleLandlord landlord;

  @BeforeEach
  void make() throws ConfigurationException {
    landlord =
        new ModuleLandlord(
            "atrv1/gps", EmptyConfiguration.INSTANCE, Exporters.jeri(EmbeddedReggie.HOST, 2000));
  }

  @AfterEach
  void end() {
    landlord.close();
  }

  @Test
  void countsAClientFromGrantToCancel() throws Exception {
    landlord.start();
    landlord.start();
    Lease first = landlord.grant(10_000);
    Lease second = landlord.grant(10_000);
    assertThat(landlord.clients()).isEqualTo(2);
    assertThat(first.getExpiration() - System.currentTimeMillis())
        .isCloseTo(10_000L, within(1_000L));
    first.cancel();
    assertThat(landlord.clients()).isEqualTo(1);
    assertThatThrownBy(first::cancel)
        .isInstanceOf(UnknownLeaseException.class)
        .hasMessage("atrv1/gps knows no such lease; it has expired");
    second.cancel();
    assertThat(landlord.clients()).isZero();
  }

  @Test
  void renewsALeaseBeforeItExpires() throws Exception {
    landlord.start();
    Lease lease = landlord.grant(2_000);
    lease.renew(30_000);
    assertThat(lease.getExpiration() - System.currentTimeMillis())
        .isCloseTo(30_000L, within(1_000L));
    assertThatThrownBy(() -> lease.renew(120_000))
        .isInstanceOf(LeaseDeniedException.class)
        .hasMessageContaining("lease 120 s > longest allowed 30 s");
    assertThat(landlord.clients()).as("a renewal refused ends no lease").isEqualTo(1);
  }

  @Test
  void forgetsAClientWhoseLeaseRanOut() throws Exception {
    landlord.start();
    Lease lease = landlord.grant(20);
    await().atMost(PATIENCE).until(() -> landlord.clients() == 0);
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
    assertThatThrownBy(() -> landlord.grant(millis))
        .isInstanceOf(LeaseDeniedException.class)
        .hasMessage(sentence);
    assertThat(landlord.clients()).isZero();
  }

  @Test
  void grantsItsOwnChoiceToWhoWantsAny() throws Exception {
    landlord.start();
    Lease lease = landlord.grant(Lease.ANY);
    assertThat(lease.getExpiration() - System.currentTimeMillis())
        .as("a third of the longest")
        .isCloseTo(10_000L, within(1_000L));
    assertThat(landlord.grant(30_000).getExpiration()).isGreaterThan(lease.getExpiration());
  }

  @Test
  void grantsNothingBeforeStartAndAfterClose() throws Exception {
    assertThatThrownBy(() -> landlord.grant(1_000))
        .isInstanceOf(LeaseDeniedException.class)
        .hasMessage("atrv1/gps grants no leases now; it starts or stops");
    landlord.start();
    Lease lease = landlord.grant(10_000);
    landlord.close();
    landlord.close();
    assertThat(landlord.clients()).isZero();
    assertThatThrownBy(() -> landlord.grant(1_000)).isInstanceOf(LeaseDeniedException.class);
    assertThatThrownBy(() -> lease.renew(1_000)).isInstanceOf(java.rmi.RemoteException.class);
  }

  @Test
  void renewsAndCancelsManyAtOnceAndTellsWhichFailed() throws Exception {
    landlord.start();
    LandlordLease good = (LandlordLease) landlord.grant(5_000);
    LandlordLease other = (LandlordLease) landlord.grant(5_000);
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
    assertThat(landlord.clients()).isZero();
    assertThat(landlord.cancelAll(new Uuid[0])).isNull();
  }

  @Test
  void takesItsTermsFromTheConfiguration() throws Exception {
    ModuleLandlord strict =
        new ModuleLandlord(
            "atrv1/gps",
            new SuppliedConfiguration(
                Map.of(
                    "org.dfra.river.lease.longestLease", () -> 500L,
                    "org.dfra.river.lease.defaultLease", () -> 100L)),
            Exporters.jeri(EmbeddedReggie.HOST, 2000));
    try (strict) {
      strict.start();
      assertThatThrownBy(() -> strict.grant(501))
          .hasMessageContaining("lease 0.501 s > longest allowed 0.5 s");
      assertThat(strict.grant(Lease.ANY).getExpiration() - System.currentTimeMillis())
          .isLessThanOrEqualTo(100);
    }
    assertThatThrownBy(() -> terms(0L, 0L))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("longestLease = 0 ms < 1 ms");
    assertThatThrownBy(() -> terms(10L, 11L))
        .hasMessageContaining("defaultLease 11 ms > longestLease 10 ms");
  }

  private static void terms(long longest, long usual) throws ConfigurationException {
    new ModuleLandlord(
        "atrv1/gps",
        new SuppliedConfiguration(
            Map.of(
                "org.dfra.river.lease.longestLease", () -> longest,
                "org.dfra.river.lease.defaultLease", () -> usual)),
        Exporters.jeri(EmbeddedReggie.HOST, 2000));
  }

  @Test
  void aRemoteClientKeepsItsLeaseByRiversRenewalManager() throws Exception {
    ServedModule<ThermometerServer> module =
        ServedModule.of(
            ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class);
    try (ThermometerServer server = module.serve()) {
      RemoteThermometer remote = (RemoteThermometer) server.getProxy();
      assertThatThrownBy(() -> remote.use(120_000))
          .as("the sentence crosses the wire")
          .isInstanceOf(LeaseDeniedException.class)
          .hasMessageContaining("lease 120 s > longest allowed 30 s");
      Lease lease = remote.use(400);
      long granted = lease.getExpiration();
      AtomicReference<LeaseRenewalEvent> failure = new AtomicReference<>();
      LeaseListener listener = failure::set;
      LeaseRenewalManager manager =
          new LeaseRenewalManager(
              new SuppliedConfiguration(
                  Map.of("net.jini.lease.LeaseRenewalManager.roundTripTime", () -> 200L)));
      manager.renewUntil(lease, Lease.FOREVER, 400, listener);
      await().atMost(PATIENCE).until(() -> lease.getExpiration() > granted + 400);
      assertThat(failure.get()).as("a renewal that failed").isNull();
      manager.cancel(lease);
      assertThatThrownBy(lease::cancel).isInstanceOf(UnknownLeaseException.class);
    }
  }
}
