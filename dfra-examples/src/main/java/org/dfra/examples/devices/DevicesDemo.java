package org.dfra.examples.devices;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.examples.devices.DevicesReport.CapturedImage;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.examples.harness.DemoRunner;
import org.dfra.examples.harness.DemoRunner.Demo;
import org.dfra.examples.harness.SimulationProcess;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.PanTiltCommand.PointAt;
import org.dfra.flow.effector.PanTiltEffector;
import org.dfra.flow.effector.PanTiltState;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.geometry.GeoPosition;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;
import org.dfra.report.terminal.Table;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.jspecify.annotations.Nullable;

/**
 * One robot in a simulated world: a client finds its devices by capability, a script drives it
 * around a square, the drive's process is killed on one side, and all readings go into a report.
 */
public final class DevicesDemo implements Demo {

  private static final String WORLD = "yard.xml";
  private static final String ROBOT = "atrv1";
  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;
  private static final Duration LEASE = Duration.ofSeconds(3);
  private static final int STANDING_RATES = 200; // readings of the gyro
  private static final double HEAD_SPEED = 1; // rad/s

  /** The side, counted from 0, in whose middle the drive is killed. */
  private static final int KILL_SIDE = 1;

  private final ProgressReporter progress;
  private final Path report;
  private @Nullable Instant killed;
  private @Nullable Instant lastCommand;

  /**
   * @param report the folder of its report
   */
  public DevicesDemo(ProgressReporter progress, Path report) {
    this.progress = progress;
    this.report = report;
  }

  @Override
  public boolean run() {
    return DemoRunner.run(progress, this::play);
  }

  private void play(DemoEnvironment environment) throws Exception {
    progress.section("starting the world", "A world starts, and a robot in it");
    Instant begin = Instant.now();
    SimulationProcess field = SimulationProcess.start(environment, WORLD);
    Map<String, String> links = field.links(ROBOT);
    progress.say(
        "The simulated world \"%s\" runs in its own process. It has %d links to devices of %s; each"
            + " uses its device's byte protocol, so the real drivers read them.",
        field.startMessage().world(), links.size(), ROBOT);
    DemoRobot robot = DemoRobot.of(environment, "simulated", ROBOT, links);
    ProgressReporter.Stopwatch coldStart = progress.stopwatch();
    List<RobotBootstrap.ServiceReference> services = robot.bringUp();
    progress.say(
        "The robot is up after %s: %s, in service groups under phoenix.",
        QuantityText.seconds(coldStart.elapsed()),
        services.stream()
            .map(RobotBootstrap.ServiceReference::name)
            .collect(Collectors.joining(", ")));
    try (ModuleDirectory directory =
        new JiniModuleDirectory(DemoEnvironment.ADDRESS, List.of(), List.of(robot.locator()))) {
      RobotDevices devices = new RobotDevices(directory);
      meet(devices, coldStart);
      GeoPosition datum = datum(field);
      try (DeviceRecorders streams = new DeviceRecorders(devices, datum, begin);
          Heading heading = Heading.start(devices.one(devices.gyro).module())) {
        streams.map.mounted(devices.one(devices.laser).module().localTransform());
        drive(environment, robot, devices, streams, heading);
        List<CapturedImage> photos = lookAround(devices, streams);
        judge(field, begin);
        write(field, streams, begin, photos);
      }
    }
  }

  private static GeoPosition datum(SimulationProcess field) {
    return field.startMessage().datum();
  }

  private void meet(RobotDevices devices, ProgressReporter.Stopwatch sinceColdStart)
      throws Exception {
    progress.section("finding the devices", "A client queries by capability");
    DemoAssertions.await("that every device works", PATIENCE, devices::areAllAnswered);
    Duration cold = sinceColdStart.elapsed();
    Table table = new Table("NEEDED", "FOUND");
    for (RobotDevices.Question<?> each : devices.questions()) {
      ModuleListing<?> answer = devices.one(each);
      table.row(each.need(), answer.path());
    }
    progress.show(table);
    progress.say("Each was found by its capabilities; the client's code has no names.");
    progress.figure("cold start to every device working and shown", cold, Duration.ofSeconds(20));
  }

  private void drive(
      DemoEnvironment environment,
      DemoRobot robot,
      RobotDevices devices,
      DeviceRecorders streams,
      Heading heading)
      throws Exception {
    progress.section(
        "driving the square", "The robot drives a square, and its drive's process is killed");
    DemoAssertions.await(
        "that the gyro publishes its rate",
        PATIENCE,
        () -> heading.stationarySamples() >= STANDING_RATES);
    progress.say(
        "The robot is stationary, so its gyro measures its own bias: %.4f rad/s.",
        heading.calibrate());
    DriveEffector drive = devices.one(devices.drive).module();
    long process = robot.process("drive");
    SquareScript[] script = new SquareScript[1];
    script[0] =
        new SquareScript(
            drive,
            streams.odometry,
            streams.track,
            heading,
            (side, metres) -> {
              if (killed == null && side == KILL_SIDE && metres > SquareScript.SIDE / 2) {
                kill(environment, process, script[0].lastCommand());
              }
            });
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    script[0].run();
    progress.say(
        "Phoenix restarted the drive as process %d. The script's command lease had ended with the old"
            + " process; the script acquired a new one, read the odometry, and finished the square."
            + " The square took %s in all.",
        robot.process("drive"), QuantityText.seconds(watch.elapsed()));
    DemoAssertions.require(killed != null, "the drive was never killed");
    DemoAssertions.require(
        script[0].resumptions() > 0, "the script did not detect that its drive was killed");
  }

  private void kill(DemoEnvironment environment, long process, Instant lastSent) throws Exception {
    environment.signal("KILL", process);
    killed = Instant.now();
    lastCommand = lastSent;
    progress.say(
        "On the second side, at full speed, process %d was killed: the driver of the wheels. No"
            + " program can command the wheels to stop now.",
        process);
  }

  private List<CapturedImage> lookAround(RobotDevices devices, DeviceRecorders streams)
      throws Exception {
    progress.section("turning the head", "The pan-tilt unit turns the cameras");
    PanTiltEffector head = devices.one(devices.panTilt).module();
    List<CapturedImage> photos = new ArrayList<>();
    try (CommandLease lease = head.acquireCommandLease(LEASE)) {
      for (double pan : new double[] {0, Math.PI / 4, -Math.PI / 4}) {
        double down = -0.2;
        head.execute(lease.key(), new PointAt(pan, down, HEAD_SPEED));
        DemoAssertions.await(
            "that the pan-tilt unit has reached its target",
            PATIENCE,
            () -> {
              @Nullable PanTiltState state = streams.panTilt.last();
              return state != null && Math.abs(state.pan() - pan) < 0.01 && !state.isMoving();
            });
        String where =
            pan == 0
                ? "ahead"
                : Math.round(Math.toDegrees(Math.abs(pan)))
                    + (pan > 0 ? "° to the left" : "° to the right");
        photos.add(new CapturedImage(next(streams.camera), "Visible, turned " + where));
        photos.add(new CapturedImage(next(streams.thermal), "Thermal, turned " + where));
      }
    }
    progress.say(
        "The pan-tilt unit and each camera are separate modules. The cameras' images are rendered from"
            + " the world with the pose of the pan-tilt unit; %d images are in the report.",
        photos.size());
    return photos;
  }

  /** An image that was exposed after this call. */
  private static CameraImage next(ReadingRecorder<CameraImage> camera) throws Exception {
    CameraImage unused = await(camera, camera.count());
    return await(camera, camera.count());
  }

  private static CameraImage await(ReadingRecorder<CameraImage> camera, long before)
      throws Exception {
    @Nullable CameraImage image = camera.next(before, PATIENCE);
    if (image == null) {
      throw new IOException("no image of " + camera.path() + " was received");
    }
    return image;
  }

  private void judge(SimulationProcess field, Instant begin) throws Exception {
    progress.section("looking at the truth", "Comparison with the ground truth");
    GroundTruthTrack truth = GroundTruthTrack.read(field.truth(), ROBOT, begin);
    Instant moment = java.util.Objects.requireNonNull(killed);
    Instant command = java.util.Objects.requireNonNull(lastCommand);
    @Nullable Instant stood = truth.stoppedSince(moment);
    DemoAssertions.require(stood != null, "the robot did not stop after its drive was killed");
    double speed = truth.speedAt(moment);
    Duration sinceCommand = Duration.between(command, stood);
    progress.say(
        "The drive's process died at %.2f m/s. The wheels stopped %s after the last command: their"
            + " controller stops when it receives no commands.",
        speed, QuantityText.seconds(sinceCommand));
    DemoAssertions.require(speed > 0.3, "the robot was too slow when its drive was killed");
    progress.requirement(
        "drive's last command to the robot standing", sinceCommand, Duration.ofMillis(500));
    progress.say(
        "The square ended %.2f m from its start: the odometry missed the wheels' motion while their"
            + " driver was dead, and the wheels slip.",
        truth.closingError());
  }

  private void write(
      SimulationProcess field, DeviceRecorders streams, Instant begin, List<CapturedImage> photos)
      throws Exception {
    progress.section("writing the report", "The report");
    long silent = streams.all().stream().filter(each -> each.count() == 0).count();
    DemoAssertions.require(silent == 0, silent + " streams had no readings");
    GroundTruthTrack truth = GroundTruthTrack.read(field.truth(), ROBOT, begin);
    Path file =
        new DevicesReport(streams, truth, begin, java.util.Objects.requireNonNull(killed))
            .write(report, progress.figures().all(), photos, field.truth());
    progress.say("Plots of every stream are in %s, and the data as CSV beside it.", file);
  }
}
