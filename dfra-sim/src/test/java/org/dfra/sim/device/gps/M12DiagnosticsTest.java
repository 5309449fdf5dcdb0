package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitNoLink;
import static org.dfra.sim.device.Modules.awaitPassed;
import static org.dfra.sim.device.Modules.awaitRecovered;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.sim.device.FastClock;
import org.dfra.sim.device.Modules;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The real driver examines and mends the emulated receiver, and lets it rest. */
@Timeout(180)
class M12DiagnosticsTest {

  private static final Duration SECOND = Duration.ofSeconds(1);
  private static final GeoPosition PLACE = new GeoPosition(52.91, 6.86, 55);

  private final InstantSource clock = FastClock.of(5);
  private M12Emulator emulator;
  private M12PlusImpl gps;

  @BeforeEach
  void start() throws IOException {
    emulator = new M12Emulator(M12EmulatorSettings.at(PLACE).withBaud(115_200), clock);
    emulator.start();
    gps =
        new M12PlusImpl(
            new ModuleContext(
                "atrv1",
                "gps_front",
                Parameters.of(
                    "atrv1/gps_front", Map.of("link", emulator.url(), "idle_period", "5")),
                clock));
    gps.start();
    awaitReadiness(Readiness.READY);
  }

  @AfterEach
  void end() {
    gps.close();
    emulator.close();
  }

  @Test
  void passesItsTestsWhenAllIsWell() {
    assertThat(gps.tests())
        .containsExactly(
            "link", "positions", "satellites", "identification", "antenna", "integrity");
    await()
        .until(() -> gps.test("integrity").passed()); // the first @@Hn comes after the first @@Ha
    awaitPassed(gps);
    assertThat(awaitPassed(gps, "identification").finding()).isEqualTo("it says it is P283T12T11");
    assertThat(awaitPassed(gps, "satellites").finding())
        .startsWith("9 in view, 9 tracked, 9 used: G14 10° up, 158° from north, ");
    assertThat(gps.preconditions().get(0))
        .hasToString(
            "Precondition[quantity=temperature of the receiver, min=-40.0, max=85.0, unit=°C]");
  }

  @Test
  void findsASilentReceiver() {
    emulator.cable().mute();
    assertThat(gps.test("identification").finding())
        .isIn(
            "it has not answered @@Cj within 3 s",
            "the link is not open: " + emulator.url() + ": no position frame for 5 s");
    emulator.cable().restore();
  }

  @Test
  void findsACutLinkAndReopensIt() {
    emulator.cable().unplug();
    awaitReadiness(Readiness.INITIALIZING);
    for (String test : List.of("link", "positions")) {
      awaitNoLink(gps, test);
    }
    emulator.cable().restore();
    awaitRecovered(gps, "reopen_link");
    awaitReadiness(Readiness.READY);
  }

  @Test
  void reopensALinkThatIsWell() {
    awaitRecovered(gps, "reopen_link");
    assertThat(gps.history().failures()).isPositive();
    awaitReadiness(Readiness.READY);
  }

  @Test
  void reinitialisesTheReceiver() {
    Diagnosis mended = awaitRecovered(gps, "reinitialise");
    assertThat(mended.finding()).contains("set to its defaults");
    awaitReadiness(Readiness.READY);
    awaitPassed(gps, "positions");
  }

  @Test
  void setsTheReceiversClock() {
    Diagnosis set = awaitRecovered(gps, "set_time");
    assertThat(set.finding()).startsWith("the receiver's clock shows 2026-01-21T");
  }

  @Test
  void restsWhenItsLastClientIsGoneAndComesBackWithTheNext() throws Exception {
    assertThat(gps.updateRate()).as("before its first client").isEqualTo(1);
    ModuleLease lease = gps.acquireLease(Duration.ofSeconds(30));
    awaitReadiness(Readiness.ACTIVE);
    lease.close();
    awaitReadiness(Readiness.READY);
    assertThat(gps.updateRate()).isEqualTo(0.2);
    await("a rare position is no missing one")
        .until(
            () -> {
              long failures = gps.history().failures();
              assertPeriod(5);
              return gps.history().failures() == failures && gps.readiness() == Readiness.READY;
            });
    List<Instant> fixes = new CopyOnWriteArrayList<>();
    try (Subscription unused = listen(fixes)) {
      assertThat(gps.updateRate()).isEqualTo(1);
      await().until(() -> fixes.size() >= 6);
      awaitReadiness(Readiness.ACTIVE);
      await() // a receiver leaves moments out that it has slept through
          .until(() -> Duration.between(last(fixes, 2), last(fixes, 1)).equals(SECOND));
    }
    gps.setParameter("idle_period", "3");
    assertThat(gps.updateRate()).isEqualTo(1 / 3.0);
    assertPeriod(3);
    gps.setParameter("idle_period", "1");
    gps.setParameter("period", "2");
    assertThat(gps.updateRate()).as("never more often than at work").isEqualTo(0.5);
  }

  /** Waits for two positions in a row that are so far apart, without becoming a client. */
  private void assertPeriod(int seconds) {
    await()
        .until(
            () -> {
              Instant first = gps.fix().utc();
              await().until(() -> !gps.fix().utc().equals(first));
              return Duration.between(first, gps.fix().utc()).equals(Duration.ofSeconds(seconds));
            });
  }

  private static Instant last(List<Instant> fixes, int fromTheEnd) {
    return fixes.get(fixes.size() - fromTheEnd);
  }

  private Subscription listen(List<Instant> fixes) {
    return gps.subscribe(
        delivery -> {
          if (delivery.event() instanceof NewReading reading
              && reading.reading() instanceof GpsFix fix) {
            fixes.add(fix.utc());
          }
        },
        DeliveryPolicy.keepLast(100));
  }

  private void awaitReadiness(Readiness expected) {
    Modules.awaitReadiness(gps, expected);
  }
}
