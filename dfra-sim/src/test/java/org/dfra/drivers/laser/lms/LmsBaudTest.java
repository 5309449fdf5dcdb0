package org.dfra.drivers.laser.lms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.sim.device.Modules.awaitReadiness;

import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.Map;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.sim.device.Cable;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.FastClock;
import org.dfra.sim.device.laser.Laser;
import org.dfra.sim.device.laser.LmsDevice;
import org.dfra.sim.device.laser.LmsEmulatorSettings;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The driver and the emulated laser over a line whose two ends have speeds of their own, so that
 * they understand each other only at the same. It stands in the driver's package to open the link
 * its own way.
 */
@Timeout(240)
@Execution(ExecutionMode.CONCURRENT) // devices are waited for
class LmsBaudTest {

  private final InstantSource clock = FastClock.of(Laser.SPEED);
  private LmsDevice device;
  private Cable port;
  private DeviceEmulator emulator;

  /** A link that sets the speed of the emulated port, as a serial port's does. */
  private record PortLink(SerialLink tcp, Cable port, int fastest) implements SerialLink {

    @Override
    public int read(byte[] buffer, int offset, int length, Duration timeout) {
      return tcp.read(buffer, offset, length, timeout);
    }

    @Override
    public void write(byte[] bytes) throws IOException {
      tcp.write(bytes);
    }

    @Override
    public void setBaud(int baud) throws IOException {
      if (baud > fastest) {
        throw new IOException("this port cannot do " + baud + " baud");
      }
      port.setPortBaud(baud);
    }

    @Override
    public boolean isOpen() {
      return tcp.isOpen();
    }

    @Override
    public void close() {
      tcp.close();
    }
  }

  private void start(LmsEmulatorSettings makeup, int portBaud) throws IOException {
    device = new LmsDevice(Laser.SPIRAL, makeup);
    emulator = new DeviceEmulator("laser", 0, device, clock);
    port = emulator.cable();
    port.setPortBaud(portBaud);
    emulator.start();
  }

  @AfterEach
  void end() {
    emulator.close();
  }

  @ParameterizedTest
  @CsvSource({
    "9600, 38400",
    "19200, 38400",
    "38400, 38400",
    "500000, 38400",
    "38400, 500000",
    "500000, 9600"
  })
  void findsALaserThatWasLeftAtAnySpeedAndSetsTheWantedOne(int left, int wanted)
      throws IOException {
    start(LmsEmulatorSettings.factoryDefault().withBaud(left), 9600);
    try (LmsImpl driver = driver(500_000, "baud", Integer.toString(wanted))) {
      awaitReadiness(driver, Readiness.READY);
      assertThat(port.portBaud()).isEqualTo(wanted);
      assertThat(Laser.scan(driver).beams()).isEqualTo(361);
      assertThat(driver.updateRate()).isEqualTo(new LmsVariant(180, 50).rate(wanted));
    }
  }

  @Test
  void findsALaserThatWasLeftStreamingByADriverThatDied() throws IOException {
    start(LmsEmulatorSettings.factoryDefault(), 9600);
    try (LmsImpl first = driver(500_000, "baud", "19200")) {
      awaitReadiness(first, Readiness.READY);
    } // says no goodbye
    assertThat(device.isStreaming()).isTrue();
    port.setPortBaud(9600);
    try (LmsImpl second = driver(500_000, "baud", "38400")) {
      awaitReadiness(second, Readiness.READY);
      assertThat(device.baud()).isEqualTo(38_400);
    }
  }

  @Test
  void findsALaserAgainThatWakesAtItsSlowestSpeed() throws IOException {
    start(LmsEmulatorSettings.factoryDefault().withWarmUp(Duration.ofSeconds(2)), 9600);
    try (LmsImpl driver = driver(500_000, "baud", "38400")) {
      awaitReadiness(driver, Readiness.READY);
      Diagnosis reset = driver.recover("reset");
      assertThat(reset.passed()).as("%s", reset).isTrue();
      awaitReadiness(driver, Readiness.READY);
      assertThat(device.baud()).isEqualTo(38_400);
    }
  }

  @Test
  void leavesTheLaserAtASpeedThatThePortHas() throws IOException {
    start(LmsEmulatorSettings.factoryDefault(), 9600);
    try (LmsImpl driver = driver(115_200, "baud", "500000")) {
      awaitReadiness(driver, Readiness.READY);
      assertThat(device.baud()).isEqualTo(9600);
    }
  }

  @Test
  void keepsTheSpeedOfASerialServer() throws IOException {
    start(LmsEmulatorSettings.factoryDefault().withBaud(19_200), 19_200);
    try (LmsImpl driver = Laser.driverAt(emulator.url(), clock)) {
      driver.start();
      awaitReadiness(driver, Readiness.READY);
      assertThat(device.baud()).isEqualTo(19_200);
      assertThat(driver.updateRate()).isEqualTo(new LmsVariant(180, 50).rate(19_200));
    }
  }

  @Test
  void understandsNothingAtAnotherSpeedThatItMustKeep() throws IOException {
    start(LmsEmulatorSettings.factoryDefault().withBaud(38_400), 9600);
    try (LmsImpl driver = driver(500_000, "baud", "keep")) {
      assertThat(driver.test("type").passed()).isFalse();
      assertThat(driver.readiness()).isEqualTo(Readiness.INITIALIZING);
      port.setPortBaud(38_400); // somebody sets the server up
      awaitReadiness(driver, Readiness.READY);
    }
  }

  @Test
  void aFollowingServerNeedsNoSearch() throws IOException {
    start(LmsEmulatorSettings.factoryDefault(), 0);
    try (LmsImpl driver = Laser.driverAt(emulator.url(), clock, "baud", "500000")) {
      driver.start();
      awaitReadiness(driver, Readiness.READY);
      assertThat(device.baud()).isEqualTo(500_000);
    }
  }

  /** Over a port of this fastest speed. */
  private LmsImpl driver(int fastest, String... parameters) {
    Map<String, String> all = new HashMap<>(Map.of("link", emulator.url()));
    for (int i = 0; i < parameters.length; i += 2) {
      all.put(parameters[i], parameters[i + 1]);
    }
    LinkAddress address = LinkAddress.parse(emulator.url());
    Ticker ticker = Ticker.of(clock);
    LmsImpl driver =
        new LmsImpl(
            new ModuleContext("atrv1", "laser", Parameters.of("atrv1/laser", all), clock),
            ticker,
            () -> new PortLink(address.open(ticker), port, fastest));
    driver.start();
    return driver;
  }
}
