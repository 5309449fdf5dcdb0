package org.dfra.examples.mission;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.robot.LocalRobot;
import org.dfra.core.state.StateStore;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.Subscription;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.module.Module;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.run.Simulation.DeviceEndpoint;
import org.dfra.sim.time.LockStep;
import org.dfra.sim.world.GroundTruth.Collision;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;

/**
 * A search in one JVM, in lock-step: real drivers with emulated devices, the modules in one
 * process, no network. It is deterministic: the same scenario gives the same search, bit by bit.
 */
public final class LockStepMission implements Mission {

  /** The estimator that robots steer by; others only estimate. */
  public static final String STEERING = RobotLog.STEERING;

  private static final Instant BEGIN = Instant.parse("2026-11-21T12:00:00Z");
  private static final Duration SAMPLE = Duration.ofMillis(100);
  private static final Duration READY = Duration.ofMinutes(3);

  private final Scenario scenario;
  private final Duration longest;
  private final UnaryOperator<RobotDescription> adapt;
  private final boolean endsAtCollision;

  /**
   * @param longest timeout of a search, robots' time
   * @param adapt changes each robot's description before use
   * @param endsAtCollision whether it ends with the first collision
   */
  public LockStepMission(
      Scenario scenario,
      Duration longest,
      UnaryOperator<RobotDescription> adapt,
      boolean endsAtCollision) {
    this.scenario = scenario;
    this.longest = longest;
    this.adapt = adapt;
    this.endsAtCollision = endsAtCollision;
  }

  /** One monitored robot. */
  private final class MonitoredRobot {
    private final String name;
    private final RasterSearch search;
    private final LocalFrame frame = scenario.region().frame();
    private final RobotLog log;

    MonitoredRobot(String name, InMemoryModuleDirectory directory) throws IOException {
      this.name = name;
      this.search =
          directory.find(ModuleQuery.of(RasterSearch.class).robot(name)).stream()
              .findFirst()
              .orElseThrow(() -> new IOException(name + " has no RasterSearch; add one to its XML"))
              .module();
      this.log = new RobotLog(name, frame);
      for (Class<? extends Module> kind : RobotLog.RECORDED_KINDS) {
        directory.find(log.query(kind)).forEach(each -> listen(each.name(), each.module()));
      }
    }

    private void listen(String module, Module source) {
      Subscription unused =
          ((ModuleImpl) source).subscribe(log.listener(module), DeliveryPolicy.latestReading());
    }

    MissionProgressListener.RobotProgress sample(
        double time,
        Map<String, GroundTruthPose> poses,
        GroundTruthClearance bodies,
        LocalFrame field)
        throws IOException {
      GroundTruthPose truth = Objects.requireNonNull(poses.get(name));
      LocalPosition at =
          frame.toLocal(field.toGeo(new LocalPosition(truth.east(), truth.north(), 0)));
      return log.sample(
          new RobotLog.GroundTruth(
              time,
              at.east(),
              at.north(),
              truth.yaw(),
              truth.speed(),
              bodies.clearance(name, poses)),
          search.status());
    }
  }

  /**
   * Runs it.
   *
   * @throws IOException if it could not start; the message names the cause
   */
  @Override
  public MissionResult run(MissionProgressListener listener) throws IOException {
    LockStep time = new LockStep(BEGIN);
    List<LocalRobot> robots = new ArrayList<>();
    try (Simulation simulation = Simulation.inLockStep(scenario.world(), time);
        InMemoryModuleDirectory directory = new InMemoryModuleDirectory(time)) {
      simulation.start();
      try {
        Map<String, String> links = links(simulation.endpoints());
        for (Path xml : scenario.robots()) {
          RobotDescription description = adapt.apply(RobotXml.read(xml, links::get));
          robots.add(new LocalRobot(description, directory, time, path -> StateStore.inMemory()));
        }
        robots.forEach(LocalRobot::start);
        return search(simulation, directory, time, robots, listener);
      } finally {
        robots.forEach(LocalRobot::close);
      }
    }
  }

  @Override
  public String mode() {
    return "local";
  }

  private static Map<String, String> links(List<DeviceEndpoint> lines) {
    Map<String, String> links = new HashMap<>();
    lines.forEach(line -> links.put(line.linkVariable(), line.link()));
    return links;
  }

  private MissionResult search(
      Simulation simulation,
      InMemoryModuleDirectory directory,
      LockStep time,
      List<LocalRobot> robots,
      MissionProgressListener listener)
      throws IOException {
    time.advance(SAMPLE);
    List<MonitoredRobot> watched = new ArrayList<>();
    for (LocalRobot robot : robots) {
      watched.add(new MonitoredRobot(robot.name(), directory));
    }
    awaitReady(time, robots);
    Instant begin = time.instant();
    for (int i = 0; i < watched.size(); i++) {
      watched.get(i).log.begin(begin);
      var unused =
          watched
              .get(i)
              .search
              .pursue(
                  new RasterGoal(
                      scenario.region().corners(),
                      scenario.swath(),
                      scenario.spacing(),
                      i % 2 == 1));
    }
    GroundTruthClearance bodies = new GroundTruthClearance(scenario.world());
    LocalFrame field = new LocalFrame(scenario.world().datum());
    double seconds = 0;
    while (seconds < longest.toSeconds()
        && anyUnderWay(watched)
        && !(endsAtCollision && !simulation.world().groundTruth().collisions().isEmpty())) {
      time.advance(SAMPLE);
      seconds = Duration.between(begin, time.instant()).toNanos() / 1e9;
      Map<String, GroundTruthPose> poses = simulation.world().groundTruth().poses(time.instant());
      List<MissionProgressListener.RobotProgress> now = new ArrayList<>();
      for (MonitoredRobot each : watched) {
        now.add(each.sample(seconds, poses, bodies, field));
      }
      listener.onProgress(now);
    }
    List<RobotMissionResult> flights = new ArrayList<>();
    for (MonitoredRobot each : watched) {
      flights.add(each.log.result(each.search.status()));
    }
    List<Collision> collisions = simulation.world().groundTruth().collisions();
    return new MissionResult(flights, collisions, marks(collisions, begin), seconds);
  }

  private static List<MissionEvent> marks(List<Collision> collisions, Instant begin) {
    return collisions.stream()
        .map(
            each ->
                new MissionEvent(
                    Duration.between(begin, each.time()).toNanos() / 1e9,
                    each.robot(),
                    "collided with " + each.other()))
        .toList();
  }

  private static boolean anyUnderWay(List<MonitoredRobot> watched) throws IOException {
    for (MonitoredRobot each : watched) {
      if (each.search.status().phase().isUnderWay()) {
        return true;
      }
    }
    return false;
  }

  private static void awaitReady(LockStep time, List<LocalRobot> robots) throws IOException {
    for (LocalRobot robot : robots) {
      Optional<ModuleImpl> late =
          robot.modules().stream()
              .filter(module -> !time.advanceUntil(() -> module.readiness().serves(), READY))
              .findFirst();
      if (late.isPresent()) {
        throw new IOException(
            late.get().identification().path()
                + " is "
                + late.get().readiness()
                + " after "
                + READY.toMinutes()
                + " minutes; see its log");
      }
    }
  }
}
