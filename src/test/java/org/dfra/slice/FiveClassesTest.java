package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationSensor;
import org.dfra.flow.sensor.TimeSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.Module;
import org.dfra.module.NotReadyException;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.sensor.RemoteGPSSensor;
import org.dfra.river.server.sensor.GPSServer;
import org.dfra.sim.device.gps.M12Emulator;
import org.dfra.sim.device.gps.M12EmulatorSettings;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** The five classes of a GPS receiver together, the driver on a receiver's real bytes. */
class FiveClassesTest {

  private static final GeoPosition PLACE = new GeoPosition(27.9506, -82.4572, 14.5);
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  private static M12Emulator receiver;
  private static GPSServer server;
  private static JiniModuleDirectory directory;

  /** From the lookup service, so that it came through JERI's streams. */
  private static GPSProxy found;

  /** The same server's proxy as any other virtual machine has it: it finds no implementation. */
  private static GPSProxy elsewhere;

  @BeforeAll
  static void serveAReceiver() throws Exception {
    receiver = new M12Emulator(M12EmulatorSettings.at(PLACE).withBaud(115_200), Instant::now);
    receiver.start();
    server = gps(receiver.url()).serve();
    directory = REGGIE.directory();
    found = (GPSProxy) directory.find(GPSSensor.class, PATIENCE).orElseThrow();
    elsewhere = new GPSProxy(found.server(), UUID.randomUUID(), found.identification());
    assertThat(elsewhere.awaitReadiness(PATIENCE)).isEqualTo(Readiness.READY);
  }

  @AfterAll
  static void switchOff() {
    directory.close();
    server.close();
    receiver.close();
  }

  /**
   * The directory learns asynchronously that a module has ended, and would give a test that looks
   * for a module of the same kind the one that the test before it has closed.
   */
  @AfterEach
  void awaitThatOnlyTheReceiverIsListed() {
    await("the receiver is the only module listed")
        .atMost(PATIENCE)
        .until(
            () ->
                directory.find(ModuleQuery.of(Module.class)).stream()
                    .map(ModuleListing::module)
                    .toList()
                    .equals(List.of(found)));
  }

  private static ServedModule<GPSServer> gps(String link) {
    return ServedModule.of(GPSServer.class, GPSProxy.class, M12PlusImpl.class)
        .with("link", link)
        .joining(REGGIE);
  }

  private static ServedModule<ThermometerServer> thermometer() {
    return ServedModule.of(
            ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
        .joining(REGGIE);
  }

  @Test
  void isFoundByWhatItCanDoAndByNothingElse() throws Exception {
    assertThat(directory.find(GPSSensor.class, PATIENCE)).contains(found);
    assertThat(directory.find(LocationSensor.class, PATIENCE).map(Object.class::cast))
        .contains(found);
    assertThat(directory.find(TimeSensor.class, PATIENCE).map(Object.class::cast)).contains(found);
    assertThat(directory.find(Thermometer.class, Duration.ofMillis(100))).isEmpty();
  }

  @Test
  void reportsTheSameFixByNetworkAsToItsOwnVirtualMachine() throws RemoteException {
    GpsFix here;
    GpsFix remote;
    do { // a new fix may come between the two questions
      here = found.fix();
      remote = elsewhere.fix();
    } while (here != found.fix());
    assertThat(remote).isEqualTo(here).isNotSameAs(here);
    assertThat(remote.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    // Ha counts milliarcseconds and centimetres: half a step is 1.4e-7 degree and 5 mm.
    assertThat(remote.position().latitude()).isCloseTo(PLACE.latitude(), within(2e-7));
    assertThat(remote.position().longitude()).isCloseTo(PLACE.longitude(), within(2e-7));
    assertThat(remote.position().height()).isCloseTo(PLACE.height(), within(0.006));
    assertThat(elsewhere.location().frame()).isEqualTo("robot/module");
    assertThat(elsewhere.time().utc()).isAfterOrEqualTo(remote.utc());
    assertThat(elsewhere.updateRate()).isEqualTo(1.0);
    assertThat(elsewhere.readiness()).isEqualTo(Readiness.READY);
  }

  @Test
  void aCallInItsOwnVirtualMachineIsNoRemoteCall() throws RemoteException {
    GpsFix local;
    GpsFix drivers;
    do {
      local = found.fix();
      drivers = server.fix();
    } while (local != found.fix());
    assertThat(local).as("what came by network would be a copy").isSameAs(drivers);
  }

  @Test
  void knowsWhoItIsWithoutAsking() throws Exception {
    Identification expected =
        new Identification("robot", "module", "Motorola Oncore M12+ GPS receiver", "DFRA", "1.0");
    assertThat(found.identification()).isEqualTo(expected).isSameAs(found.identification());
    ThermometerProxy orphan;
    try (ThermometerServer closed = thermometer().serve()) {
      orphan = (ThermometerProxy) directory.find(Thermometer.class, PATIENCE).orElseThrow();
      assertThat(orphan.identification()).isEqualTo(closed.identification());
    }
    assertThat(orphan.identification().path()).as("its server is gone").isEqualTo("robot/module");
  }

  @Test
  void proxiesAreEqualByIdentity() {
    GPSProxy samePlace = new GPSProxy(found.server(), found.id(), found.identification());
    assertThat(samePlace).isEqualTo(found).hasSameHashCodeAs(found);
    assertThat(elsewhere).as("another identity at the same server").isNotEqualTo(found);
    assertThat(found).hasToString("robot/module (GPSProxy)");
  }

  @Test
  void survivesJdkSerialization() throws Exception {
    GPSProxy copy = copy(elsewhere);
    assertThat(copy).isEqualTo(elsewhere).isNotSameAs(elsewhere);
    assertThat(copy.server()).isEqualTo(elsewhere.server());
    assertThat(copy.identification()).isEqualTo(elsewhere.identification());
    assertThat(copy.fix().position()).isEqualTo(elsewhere.fix().position());
  }

  @Test
  void leavesItsVirtualMachineWhenItIsClosed() throws Exception {
    ServedModule<ThermometerServer> module = thermometer().with("celsius", "4");
    ThermometerServer first = module.serve();
    ThermometerProxy proxy =
        (ThermometerProxy) directory.find(Thermometer.class, PATIENCE).orElseThrow();
    assertThat(proxy.celsius()).isEqualTo(4);
    assertThatThrownBy(module::serve)
        .as("two implementations of one identity")
        .hasMessageContaining("already does in this JVM");
    assertThat(proxy.celsius()).as("the first still serves").isEqualTo(4);

    first.close();
    first.close();
    assertThatThrownBy(proxy::celsius)
        .as("neither here nor by network")
        .isInstanceOf(RemoteException.class);
    assertThat(first.readiness()).isEqualTo(Readiness.STOPPED);

    try (ThermometerServer again = module.with("celsius", "5").serve()) {
      assertThat(proxy.celsius()).as("the same proxy, the new implementation").isEqualTo(5);
      assertThat(again.readiness()).isEqualTo(Readiness.READY);
    }
  }

  @Test
  void notReadyCrossesTheWireIntact() throws Exception {
    M12EmulatorSettings underTheRoof =
        M12EmulatorSettings.at(PLACE).withTimeToFirstFix(Duration.ofHours(1));
    try (StallProbe probe = StallProbe.start();
        M12Emulator blind = new M12Emulator(underTheRoof, Instant::now)) {
      blind.start();
      try (GPSServer waiting = gps(blind.url()).serve()) {
        RemoteGPSSensor remote = (RemoteGPSSensor) waiting.getProxy();
        NotReadyException thrown = catchThrowableOfType(NotReadyException.class, remote::fix);
        assertThat(thrown.readiness()).isEqualTo(Readiness.INITIALIZING);
        assertThat(thrown).hasMessageStartingWith("robot/module is INITIALIZING: ");

        StallProbe.Stopwatch began = probe.stopwatch();
        assertThat(remote.awaitReadiness(Duration.ofHours(1))).isEqualTo(Readiness.INITIALIZING);
        Timing oneCall = began.stop();
        assertThat(oneCall.took())
            .as("one call waits a second, so it ends before its deadline")
            .isGreaterThan(Duration.ofMillis(900));

        GPSProxy patient =
            new GPSProxy(remote, UUID.randomUUID(), waiting.identification()); // not local
        began = probe.stopwatch();
        assertThat(patient.awaitReadiness(Duration.ofMillis(1200)))
            .isEqualTo(Readiness.INITIALIZING);
        Timing severalCalls = began.stop();
        assertThat(severalCalls.took())
            .as("a proxy waits longer, in several calls")
            .isGreaterThan(Duration.ofMillis(1200));
        oneCall.requireWithin("one call that waits a second", Duration.ofMillis(1900));
        severalCalls.requireWithin("a wait of 1.2 s in several calls", Duration.ofMillis(2500));
      }
    }
  }

  @Test
  void waitsForEverWhereAskedTo() throws RemoteException {
    Duration longest = Duration.ofSeconds(Long.MAX_VALUE);
    assertThat(found.awaitReadiness(longest)).isEqualTo(Readiness.READY);
    assertThat(elsewhere.awaitReadiness(longest)).isEqualTo(Readiness.READY);
  }

  private static GPSProxy copy(GPSProxy proxy) throws IOException, ClassNotFoundException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(proxy);
    }
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      return (GPSProxy) in.readObject();
    }
  }
}
