package org.dfra.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Stream;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.ReceiverImpl;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.drivers.gps.nmea.NmeaImpl;
import org.dfra.drivers.gps.ubx.UbxImpl;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.Incident;
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The drivers on a serial port: socat makes a pseudo-terminal of the emulator's TCP port. Ending
 * socat pulls the cable and the whole port with it, as a USB receiver does. Skipped where socat is
 * not installed.
 */
@Timeout(60)
class SerialPortReceiverTest {

  private static final AntennaPath PLACE = AntennaPath.fixed(new GeoPosition(52.9, -6.9, 55.9));

  @TempDir private Path folder;

  static Stream<Arguments> receivers() {
    return Stream.of(
        Arguments.of(
            "m12",
            new M12Device(PLACE, 9600, Duration.ZERO),
            (Function<ModuleContext, ReceiverImpl<?>>) M12PlusImpl::new),
        Arguments.of(
            "nmea",
            new NmeaDevice(PLACE, 9600, Duration.ZERO),
            (Function<ModuleContext, ReceiverImpl<?>>) NmeaImpl::new),
        Arguments.of(
            "ubx",
            new UbxDevice(PLACE, 9600, Duration.ZERO),
            (Function<ModuleContext, ReceiverImpl<?>>) UbxImpl::new));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("receivers")
  void goesOnWhenTheCableIsPutBack(
      String name, SerialDevice device, Function<ModuleContext, ReceiverImpl<?>> driver)
      throws Exception {
    String program = Programs.find("socat");
    Path port = folder.resolve("ttyGPS");
    try (DeviceEmulator emulator = new DeviceEmulator(name, 0, device, Clock.systemUTC())) {
      emulator.start();
      Process cable = plug(program, port, emulator.port());
      try (ReceiverImpl<?> gps = driver.apply(context("serial:" + port + "?baud=9600"))) {
        gps.start();
        awaitReadiness(gps, Readiness.READY);
        Instant before = gps.fix().utc();
        Programs.end(cable);
        awaitReadiness(gps, Readiness.INITIALIZING);
        assertThat(refusal(gps)).contains("serial:" + port);
        cable = plug(program, port, emulator.port());
        awaitReadiness(gps, Readiness.READY);
        assertThat(gps.fix().utc()).isAfter(before);
        assertThat(gps.history().failures()).isEqualTo(1);
        assertThat(gps.history().recent())
            .extracting(Incident::kind)
            .contains(Incident.Kind.FAILURE, Incident.Kind.RECOVERY);
        assertThat(gps.counts().malformed()).isZero();
      } finally {
        Programs.end(cable);
      }
    }
  }

  private static Process plug(String program, Path port, int emulator) throws IOException {
    return new ProcessBuilder(program, "pty,raw,echo=0,link=" + port, "tcp:127.0.0.1:" + emulator)
        .inheritIO()
        .start();
  }

  private static ModuleContext context(String link) {
    return new ModuleContext(
        "atrv1", "gps", Parameters.of("atrv1/gps", Map.of("link", link)), Clock.systemUTC());
  }

  private static String refusal(ReceiverImpl<?> gps) {
    try {
      return "served " + gps.fix();
    } catch (NotReadyException e) {
      return String.valueOf(e.getMessage());
    }
  }

  private static void awaitReadiness(ReceiverImpl<?> gps, Readiness expected) {
    await().atMost(Duration.ofSeconds(25)).until(gps::readiness, expected::equals);
  }
}
