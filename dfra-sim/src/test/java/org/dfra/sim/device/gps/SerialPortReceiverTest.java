package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitReadiness;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.stream.Stream;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.drivers.gps.nmea.NmeaImpl;
import org.dfra.drivers.gps.ubx.UbxImpl;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.Programs;
import org.dfra.sim.device.PseudoTerminal;
import org.dfra.sim.device.SerialDevice;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The drivers on a serial port that is a pseudo-terminal. Pulling the cable takes the whole port
 * away, as with a USB receiver. Skipped where socat is not installed.
 */
@Timeout(180)
class SerialPortReceiverTest {

  private static final AntennaTrajectory PLACE =
      AntennaTrajectory.fixed(new GeoPosition(52.9, -6.9, 55.9));

  static Stream<Arguments> receivers() {
    return Stream.of(
        Arguments.of(
            "m12",
            new M12Device(PLACE, 9600, Duration.ZERO),
            (Function<ModuleContext, GpsReceiverImpl<?>>) M12PlusImpl::new),
        Arguments.of(
            "nmea",
            new NmeaDevice(PLACE, 9600, Duration.ZERO),
            (Function<ModuleContext, GpsReceiverImpl<?>>) NmeaImpl::new),
        Arguments.of(
            "ubx",
            new UbxDevice(PLACE, 9600, Duration.ZERO),
            (Function<ModuleContext, GpsReceiverImpl<?>>) UbxImpl::new));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("receivers")
  void goesOnWhenTheCableIsPutBack(
      String name, SerialDevice device, Function<ModuleContext, GpsReceiverImpl<?>> driver)
      throws Exception {
    Programs.require("socat");
    try (DeviceEmulator emulator = new DeviceEmulator(name, 0, device, Clock.systemUTC());
        PseudoTerminal port = new PseudoTerminal("ttyGPS", emulator)) {
      emulator.start();
      port.start();
      try (GpsReceiverImpl<?> gps = driver.apply(context(port.url() + "?baud=9600"))) {
        gps.start();
        awaitReadiness(gps, Readiness.READY);
        Instant before = await().until(() -> gps.fix().utc(), Objects::nonNull);
        emulator.cable().unplug();
        awaitReadiness(gps, Readiness.INITIALIZING);
        assertThat(refusal(gps)).contains(port.url());
        emulator.cable().restore();
        awaitReadiness(gps, Readiness.READY);
        await().until(() -> gps.fix().utc().isAfter(before));
        assertThat(gps.history().failures()).isPositive();
        assertThat(gps.history().recent())
            .extracting(Incident::kind)
            .contains(Incident.Kind.FAILURE, Incident.Kind.RECOVERY);
        assertThat(gps.counts().malformed()).isZero();
      }
    }
  }

  private static ModuleContext context(String link) {
    return new ModuleContext(
        "atrv1", "gps", Parameters.of("atrv1/gps", Map.of("link", link)), Clock.systemUTC());
  }

  private static String refusal(GpsReceiverImpl<?> gps) {
    try {
      return "served " + gps.fix();
    } catch (NotReadyException e) {
      return String.valueOf(e.getMessage());
    }
  }
}
