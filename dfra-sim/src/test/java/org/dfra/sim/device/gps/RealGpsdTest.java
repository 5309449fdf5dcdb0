package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.device.Modules.await;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.dfra.core.config.Parameters;
import org.dfra.core.host.FreePorts;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.drivers.gps.gpsd.GpsdImpl;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.Programs;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The driver on a real gpsd, which reads an emulated receiver of NMEA: both our parsers and our
 * emulator against somebody else's. Skipped where gpsd is not installed.
 */
@Timeout(240)
class RealGpsdTest {

  private static final GeoPosition PLACE = new GeoPosition(52.910313611, -6.866706667, 55.91);

  @TempDir private Path folder;

  @Test
  void servesWhatARealGpsdMakesOfTheEmulatedReceiver() throws Exception {
    String program = Programs.find("gpsd");
    NmeaDevice device = new NmeaDevice(AntennaTrajectory.fixed(PLACE), 38_400, Duration.ZERO);
    try (DeviceEmulator receiver = new DeviceEmulator("nmea", 0, device, Clock.systemUTC())) {
      receiver.start();
      int port = FreePorts.allocate();
      Process gpsd = gpsd(program, port, receiver.url());
      try (GpsReceiverImpl<?> gps = driver("tcp://127.0.0.1:" + port)) {
        gps.start();
        await().until(gps::readiness, Readiness.READY::equals);
        // Its first report may not have the height yet.
        GpsFix fix = await().until(gps::fix, reported -> reported.mode() == GpsFix.Mode.FIX_3D);
        assertThat(fix.position().latitude()).isCloseTo(PLACE.latitude(), within(1e-8));
        assertThat(fix.position().longitude()).isCloseTo(PLACE.longitude(), within(1e-8));
        // gpsd may have its own geoid: it adds back what it took from GGA.
        assertThat(fix.position().height()).isCloseTo(PLACE.height(), within(0.02));
        assertThat(gps.time().hostOffset().abs()).isLessThan(Duration.ofSeconds(5));
        await().until(() -> gps.satellites().size() == 9);
        assertThat(gps.counts().malformed()).isZero();
        assertThat(gps.counts().droppedBytes()).isZero();
        assertThat(gps.test("identification").finding()).startsWith("it says it is gpsd 3.");
        assertThat(gps.receiver().softwareVersion()).startsWith("3.");

        Programs.end(gpsd); // and it is started again
        await().until(gps::readiness, Readiness.INITIALIZING::equals);
        gpsd = gpsd(program, port, receiver.url());
        await().until(gps::readiness, Readiness.READY::equals);
        assertThat(gps.history().failures()).isEqualTo(1);
      } finally {
        Programs.end(gpsd);
      }
    }
  }

  private Process gpsd(String program, int port, String receiver) throws IOException {
    return new ProcessBuilder(List.of(program, "-N", "-n", "-S", Integer.toString(port), receiver))
        .redirectErrorStream(true)
        .redirectOutput(folder.resolve("gpsd.log").toFile())
        .start();
  }

  private static GpsReceiverImpl<?> driver(String link) {
    return new GpsdImpl(
        new ModuleContext(
            "atrv1", "gps", Parameters.of("atrv1/gps", Map.of("link", link)), Clock.systemUTC()));
  }
}
