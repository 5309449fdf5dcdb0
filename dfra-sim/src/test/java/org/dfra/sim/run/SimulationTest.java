package org.dfra.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.drivers.drive.rflex.RflexDriveImpl;
import org.dfra.drivers.drive.rflex.RflexOdometryImpl;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.drivers.gyro.kvh.Dsp3000Impl;
import org.dfra.drivers.laser.lms.LmsImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.sim.run.Simulation.DeviceEndpoint;
import org.dfra.sim.run.Simulation.PortPolicy;
import org.dfra.sim.time.LockStep;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.EmulatorDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(120)
class SimulationTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T12:00:00Z");
  private static final SourceLocation PLACE = new SourceLocation("yard.xml", 12);

  private static DeviceDescription device(DeviceKind kind, String name, String protocol, int port) {
    return new DeviceDescription(
        kind,
        name,
        MountPose.at(0, 0, 0.4),
        Optional.empty(),
        Map.of(),
        new EmulatorDescription(
            Optional.ofNullable(protocol.isEmpty() ? null : protocol),
            Optional.empty(),
            Optional.ofNullable(port == 0 ? null : Integer.toString(port)),
            Optional.empty()),
        PLACE);
  }

  private static WorldDescription yard(long seed, DeviceDescription... devices) {
    VehicleDescription robot = new VehicleDescription("atrv1", VehicleType.UGV, 5, 5, 0);
    for (DeviceDescription each : devices) {
      robot = robot.with(each);
    }
    return new WorldDescription("yard", seed, new GeoPosition(48, 11, 520), 20, 20).with(robot);
  }

  private static WorldDescription yard(long seed) {
    return yard(
        seed,
        device(DeviceKind.GPS, "gps", "", 0),
        device(DeviceKind.LASER, "laser", "", 0),
        device(DeviceKind.GYRO, "gyro", "", 0),
        device(DeviceKind.DRIVE, "drive", "", 0),
        device(DeviceKind.BATTERY, "battery", "", 0));
  }

  private static ModuleContext context(String module, String device, LockStep time) {
    return new ModuleContext(
        "atrv1",
        module,
        Parameters.of("atrv1/" + module, Map.of("link", "sim:atrv1/" + device)),
        time);
  }

  /** The readings of ten seconds with real drivers at the lines, three of them while driving. */
  private static List<String> readings(long seed) throws Exception {
    LockStep time = new LockStep(BEGIN);
    List<String> reported = new ArrayList<>();
    try (Simulation simulation = Simulation.inLockStep(yard(seed), time);
        M12PlusImpl gps = new M12PlusImpl(context("gps", "gps", time));
        LmsImpl laser = new LmsImpl(context("laser", "laser", time));
        Dsp3000Impl gyro = new Dsp3000Impl(context("gyro", "gyro", time));
        RflexDriveImpl drive = new RflexDriveImpl(context("drive", "drive", time));
        RflexOdometryImpl odometry = new RflexOdometryImpl(context("odometry", "drive", time))) {
      simulation.start();
      List<ModuleImpl> modules = List.of(gps, laser, gyro, drive, odometry);
      for (ModuleImpl each : modules) {
        var unused =
            each.subscribe(
                delivery -> {
                  if (delivery.event() instanceof ModuleEvent.NewReading reading) {
                    reported.add(
                        reading.reading() instanceof RangeScan scan
                            ? scan + " " + scan.hashCode()
                            : reading.reading().toString());
                  }
                },
                DeliveryPolicy.keepLast(100).withKinds(EventKind.READING));
        each.start();
      }
      for (ModuleImpl each : modules) {
        assertThat(time.advanceUntil(() -> each.readiness() == Readiness.ACTIVE, minute()))
            .as("%s", each.identification().path())
            .isTrue();
      }
      GroundTruthPose before = simulation.world().groundTruth().pose("atrv1", time.instant());
      try (CommandLease lease = drive.acquireCommandLease(Duration.ofSeconds(5))) {
        drive.execute(lease.key(), new Brake(false));
        for (int i = 0; i < 30; i++) {
          drive.execute(lease.key(), new Velocity(0.5, 0));
          time.advance(Duration.ofMillis(100));
        }
      }
      time.advance(Duration.ofSeconds(1));
      GroundTruthPose after = simulation.world().groundTruth().pose("atrv1", time.instant());
      Odometry counted = odometry.odometry();
      assertThat(after.speed()).as("speed when its commander has let go").isLessThan(0.01);
      assertThat(after.east() - before.east()).as("metres it went").isBetween(1.0, 1.6);
      assertThat(counted.x()).as("metres its wheels counted").isBetween(1.0, 1.6);
    }
    return reported;
  }

  private static Duration minute() {
    return Duration.ofMinutes(1);
  }

  @Test
  void theSameSeedGivesRealDriversTheSameReadingsAndAnotherSeedGivesOthers() throws Exception {
    List<String> first = readings(7);

    assertThat(first).hasSizeGreaterThan(200);
    assertThat(readings(7)).isEqualTo(first);
    assertThat(readings(8)).isNotEqualTo(first);
  }

  @Test
  void reportsWhichLinesThereAreAndWhichDevicesEachServes() throws Exception {
    try (Simulation simulation =
        Simulation.overTcp(yard(1), Clock.systemUTC(), PortPolicy.CONFIGURED)) {
      simulation.start();

      assertThat(simulation.endpoints())
          .extracting(DeviceEndpoint::device)
          .containsExactly("drive", "gps", "gyro", "laser");
      DeviceEndpoint drive = simulation.endpoints().get(0);
      assertThat(drive.servedDevices()).containsExactly("drive", "battery");
      assertThat(drive.linkVariable()).isEqualTo("DFRA_ATRV1_DRIVE_LINK");
      int port = Integer.parseInt(drive.link().replaceAll(".*:", ""));
      try (Socket socket = new Socket()) {
        socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 20_000);
        assertThat(socket.isConnected()).isTrue();
      }
    }
  }

  @Test
  void opensNoLineWhereOneCannotBeOpened() throws Exception {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      WorldDescription world =
          yard(
              1,
              device(DeviceKind.GPS, "a_gps", "", 0),
              device(DeviceKind.GYRO, "gyro", "", taken.getLocalPort()));
      try (Simulation simulation =
          Simulation.overTcp(world, Clock.systemUTC(), PortPolicy.CONFIGURED)) {
        assertThatThrownBy(simulation::start)
            .isInstanceOf(IOException.class)
            .hasMessageStartingWith("yard.xml:12: atrv1/gyro cannot be reached: port ")
            .hasMessageContaining("choose another, or 0 for any free one");
        assertThatThrownBy(simulation::endpoints).isInstanceOf(IllegalStateException.class);
      }
    }
  }

  @Test
  void refusesAProtocolThatNoSuchDeviceSpeaks() {
    WorldDescription world = yard(1, device(DeviceKind.GPS, "gps", "nmaea", 0));

    assertThatThrownBy(() -> Simulation.overTcp(world, Clock.systemUTC(), PortPolicy.EPHEMERAL))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "yard.xml:12: a gps does not support the protocol \"nmaea\"; did you mean \"nmea\"?");
  }

  @Test
  void namesTheLinesThatHaveACable() {
    try (Simulation simulation = Simulation.inLockStep(yard(1), new LockStep(BEGIN))) {
      assertThat(simulation.cable("atrv1", "laser").isPulled()).isFalse();
      assertThatThrownBy(() -> simulation.cable("atrv1", "battery"))
          .hasMessage(
              "there is no link to atrv1/battery; there are links to [atrv1/drive, atrv1/gps, atrv1/gyro,"
                  + " atrv1/laser]");
    }
  }
}
