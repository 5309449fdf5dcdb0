package org.dfra.example.probe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.Awaitility;
import org.awaitility.core.ConditionFactory;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.example.thermometer.TemperatureReading;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.module.NotReadyException;
import org.dfra.sim.device.DeviceEmulator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The driver with the emulated probe, by a clock that runs five times as fast. */
@Timeout(120)
class ProbeThermometerTest {

  private static final long BEGIN = System.nanoTime();
  private static final Instant ORIGIN = Instant.parse("2026-06-01T12:00:00Z");

  private final InstantSource clock = () -> ORIGIN.plusNanos((System.nanoTime() - BEGIN) * 5);

  private final ProbeDevice device = new ProbeDevice(21.5);
  private DeviceEmulator probe;

  @TempDir Path folder;

  @BeforeEach
  void switchOn() throws IOException {
    probe = emulated(0);
  }

  @AfterEach
  void switchOff() {
    probe.close();
  }

  @Test
  void reportsTheTemperature() {
    List<Reading> readings = new CopyOnWriteArrayList<>();
    try (ProbeThermometerImpl thermometer = started(Map.of("link", probe.url()));
        Subscription unused =
            thermometer.subscribe(
                delivery -> {
                  if (delivery.event() instanceof NewReading reported) {
                    readings.add(reported.reading());
                  }
                },
                DeliveryPolicy.keepLast(100))) {
      await().until(() -> readings.size() >= 3);
      assertThat(thermometer.celsius()).isEqualTo(21.5);
      assertThat(readings)
          .allSatisfy(
              reported -> assertThat(((TemperatureReading) reported).celsius()).isEqualTo(21.5));
      await().until(() -> thermometer.readiness() == Readiness.ACTIVE);
    }
  }

  @Test
  void waitsForAProbeThatIsPulledAndServesAgainWhenItIsBack() throws IOException {
    int port = probe.port();
    try (ProbeThermometerImpl thermometer = started(Map.of("link", probe.url()))) {
      await().until(() -> thermometer.readiness() == Readiness.READY);
      probe.close();
      await().until(() -> thermometer.readiness() == Readiness.INITIALIZING);
      assertThatThrownBy(thermometer::celsius)
          .isInstanceOf(NotReadyException.class)
          .hasMessageStartingWith("robot/probe is INITIALIZING: tcp://127.0.0.1:" + port);
      probe = emulated(port);
      await().until(() -> thermometer.readiness() == Readiness.READY);
      assertThat(thermometer.history().failures()).isPositive();
    }
  }

  @Test
  void takesAProbeThatIsSilentForThreePeriodsAndTwoSecondsForLost() {
    try (ProbeThermometerImpl thermometer = started(Map.of("link", probe.url()))) {
      await().until(() -> thermometer.readiness() == Readiness.READY);
      device.silence(true);
      await().until(() -> thermometer.readiness() == Readiness.INITIALIZING);
      assertThat(thermometer.history().recent().toString()).contains("no temperature for 5.0 s");
      device.silence(false);
      await().until(() -> thermometer.readiness() == Readiness.READY);
    }
  }

  @Test
  void restsWhenTheLastClientHasGone() throws Exception {
    try (ProbeThermometerImpl thermometer = started(Map.of("link", probe.url(), "period", "2"))) {
      try (ModuleLease unused = thermometer.acquireLease(Duration.ofSeconds(30))) {
        await().until(() -> device.period().toSeconds() == 2);
        assertThat(thermometer.updateRate()).isEqualTo(0.5);
      }
      await().until(() -> device.period().toSeconds() == 10);
      thermometer.setParameter("period", "20"); // it rests no faster than it works
      await().until(() -> device.period().toSeconds() == 20);
    }
  }

  @Test
  void canBeExaminedAndMended() {
    try (ProbeThermometerImpl thermometer = started(Map.of("link", probe.url()))) {
      await().until(() -> thermometer.readiness() == Readiness.READY);
      await().until(() -> thermometer.test("readings"), Diagnosis::passed);
      await().until(() -> thermometer.recover("reopen_link"), Diagnosis::passed);
      probe.close();
      await().until(() -> thermometer.readiness() == Readiness.INITIALIZING);
      Diagnosis ill = thermometer.test("readings");
      assertThat(ill.passed()).as("%s", ill).isFalse();
    }
  }

  @Test
  void readsARecordingAndCountsWhatItDropped() throws IOException {
    ByteArrayOutputStream recorded = new ByteArrayOutputStream();
    recorded.writeBytes(new byte[] {'T', '+', '0', 0, -1});
    recorded.writeBytes(ProbeDevice.line(-3.25));
    recorded.writeBytes(ProbeDevice.checked("T---.--"));
    Path recording = Files.write(folder.resolve("recording.bin"), recorded.toByteArray());
    String link = "replay:" + recording + "?loop=true";
    try (ProbeThermometerImpl thermometer = started(Map.of("link", link))) {
      await().until(() -> thermometer.readiness() == Readiness.READY);
      assertThat(thermometer.celsius()).isEqualTo(-3.25);
      await().until(() -> Integer.parseInt(parameter(thermometer, "dropped_bytes")) >= 5);
    }
  }

  @Test
  void refusesWhatIsNoPeriod() {
    for (String period : List.of("0", "61", "0x2", "often")) {
      assertThatThrownBy(() -> started(Map.of("link", probe.url(), "period", period)))
          .isInstanceOf(ConfigurationException.class)
          .hasMessageContaining("robot/probe: parameter period is \"" + period + "\"");
    }
  }

  private DeviceEmulator emulated(int port) throws IOException {
    DeviceEmulator made = new DeviceEmulator("probe", port, device, clock);
    made.start();
    return made;
  }

  private ProbeThermometerImpl started(Map<String, String> parameters) {
    ProbeThermometerImpl made =
        new ProbeThermometerImpl(
            new ModuleContext("robot", "probe", Parameters.of("robot/probe", parameters), clock));
    made.start();
    return made;
  }

  /** An overloaded machine may take its time. */
  private static ConditionFactory await() {
    return Awaitility.await().atMost(Duration.ofSeconds(30));
  }

  private static String parameter(ProbeThermometerImpl thermometer, String name) {
    return thermometer.parameters().stream()
        .filter(parameter -> parameter.name().equals(name))
        .findFirst()
        .orElseThrow()
        .value();
  }
}
