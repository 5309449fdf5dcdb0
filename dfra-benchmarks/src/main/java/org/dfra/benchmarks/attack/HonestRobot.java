package org.dfra.benchmarks.attack;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import org.dfra.benchmarks.task.Task;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.time.RobotTime;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.discovery.MulticastSearch;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.ClassServer;
import org.dfra.river.loading.TrustedCode;
import org.dfra.sim.device.drive.RflexDevice;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.run.Simulation.DeviceEndpoint;
import org.dfra.sim.run.Simulation.PortPolicy;
import org.dfra.sim.world.GroundTruth;
import org.dfra.sim.world.file.WorldXml;
import org.jspecify.annotations.Nullable;

/**
 * A robot of the team {@code raster} with its registrar, a class server without jars and the
 * simulated field around it, in one process. It prints {@code registrar PORT classes PORT}, and for
 * each line of its input the wheels' state, {@code wheels MOVED CRUISED HALTED}: microseconds since
 * the epoch when they last moved at all, when they last moved at {@link #CRUISE}, and when their
 * controller received the first stop command since.
 *
 * <p>Arguments enable two optional parts:
 *
 * <pre>
 *   search           searches for lookup services by multicast that does not leave this computer
 *   phoenix=FOLDER   starts a phoenix with one group, which outlives it: "phoenix PORT PID" as soon
 *                    as it runs, then "lock FILE" of the group. It answers "groups" in its input
 *                    with "groups COUNT" of that phoenix.
 * </pre>
 *
 * <p>Besides the robot's own threads, one thread samples the robot's true speed, {@value #RATE}
 * times a second.
 */
public final class HonestRobot implements Task {

  /** The robot's name. */
  static final String NAME = "atrv1";

  private static final String DRIVE = "drive"; // its link in the world

  /** The host address that it listens on. */
  static final String HOST = "127.0.0.1";

  /** Argument: the robot discovers by multicast. */
  public static final String SEARCH = "search";

  /** Prefix of an argument: start a phoenix; the folder of its state follows. */
  public static final String PHOENIX = "phoenix=";

  /** Input line: print the number of phoenix's groups. */
  public static final String GROUPS = "groups";

  /** The speed at which the operator drives, metres per second. */
  static final double CRUISE = 0.3;

  /** Below this fraction of {@link #CRUISE}, the robot counts as slower. */
  private static final double SLOWER = 0.9;

  /** Metres per second; below, the wheels count as stopped. */
  private static final double STOPPED = 0.01;

  private static final int RATE = 200; // hertz

  private static final Path CONFIG = Path.of(System.getProperty("dfra.root", "."), "config");

  /** The field. */
  static final Path WORLD = CONFIG.resolve("worlds/raster.xml");

  /** The robot's description. */
  static final Path XML = CONFIG.resolve("teams/raster/" + NAME + ".xml");

  private volatile Instant moved = Instant.EPOCH;
  private volatile Instant cruised = Instant.EPOCH;
  private @Nullable RflexDevice controller; // before the first line of input
  private @Nullable PhoenixUnderTest phoenix;

  /** Called by {@code TaskMain} by reflection. */
  public HonestRobot() {}

  /** Arguments: those of the class. */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    List<String> wanted = List.of(args);
    for (String each : wanted) {
      if (each.startsWith(PHOENIX)) {
        start(new PhoenixUnderTest(Path.of(each.substring(PHOENIX.length()))), out);
      }
    }
    InstantSource clock = RobotTime.clock();
    try (Simulation simulation =
        Simulation.overTcp(WorldXml.read(WORLD), clock, PortPolicy.EPHEMERAL)) {
      simulation.start();
      try (EmbeddedRobot robot = new EmbeddedRobot(described(simulation));
          ClassServer classes = new ClassServer(HOST, 0, CONFIG, List.of())) {
        robot.start();
        classes.start();
        controller = simulation.driveController(NAME, DRIVE);
        watch(simulation.world().groundTruth(), clock);
        if (wanted.contains(SEARCH)) {
          MulticastSearch unused = // its threads keep it reachable until the process ends
              LocalMulticast.search(robot.description().lookupGroups(), new IgnoringListener());
        }
        out.println("registrar " + robot.registrar().port() + " classes " + classes.port());
        BufferedReader in =
            new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line; (line = in.readLine()) != null; ) {
          out.println(answer(line));
        }
      }
    }
  }

  private void start(PhoenixUnderTest made, PrintStream out) throws Exception {
    long pid = made.start();
    out.println("phoenix " + made.port() + " " + pid);
    out.println("lock " + made.bringUp());
    phoenix = made;
  }

  private String answer(String line) throws IOException {
    PhoenixUnderTest started = phoenix;
    return line.equals(GROUPS) && started != null
        ? "groups " + started.groups()
        : "wheels " + micros(moved) + " " + micros(cruised) + " " + micros(halted());
  }

  /** When the controller received the first stop command after the last motion. */
  private Instant halted() {
    Instant first = Objects.requireNonNull(controller).firstHalt();
    return first == null ? Instant.EPOCH : first;
  }

  /** The robot is found by its own registrar; other discovered registrars do not matter here. */
  private static final class IgnoringListener implements MulticastSearch.Listener {

    @Override
    public void found(LocatedRegistrar registrar) {}

    @Override
    public void lost(LocatedRegistrar registrar) {}
  }

  private static RobotDescription described(Simulation simulation) throws Exception {
    Map<String, String> links =
        simulation.endpoints().stream()
            .filter(each -> each.robot().equals(NAME))
            .collect(Collectors.toMap(DeviceEndpoint::device, DeviceEndpoint::link));
    RobotDescription robot = DemoRobot.describe(XML, NAME, links);
    int port = robot.registrar().orElseThrow().port();
    return robot.withRegistrars(List.of("jini://" + HOST + ":" + port));
  }

  private void watch(GroundTruth truth, InstantSource clock) {
    Thread thread =
        new Thread(
            () -> {
              while (true) {
                Instant now = clock.instant();
                double speed = truth.pose(NAME, now).speed();
                moved = speed > STOPPED ? now : moved;
                cruised = speed > SLOWER * CRUISE ? now : cruised;
                LockSupport.parkNanos(TimeUnit.SECONDS.toNanos(1) / RATE);
              }
            },
            "watches the wheels");
    thread.setDaemon(true);
    thread.start();
  }

  /** Microseconds since the epoch. */
  static long micros(Instant time) {
    return ChronoUnit.MICROS.between(Instant.EPOCH, time);
  }
}
