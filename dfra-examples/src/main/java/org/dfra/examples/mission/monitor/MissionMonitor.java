package org.dfra.examples.mission.monitor;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.locks.LockSupport;
import org.dfra.behavior.RasterGoal;
import org.dfra.examples.harness.GoalSubmission;
import org.dfra.examples.mission.GroundTruthClearance;
import org.dfra.examples.mission.MissionProgressListener;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.RobotLog;
import org.dfra.examples.mission.Scenario;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.sim.world.GroundTruth.Collision;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;

/**
 * Starts the robots' search, and monitors it: ten times a second of their time it records the true
 * pose and the last readings of each, and updates the injected faults. Confined to one thread.
 *
 * @param <R> the runtime of a robot
 */
public final class MissionMonitor<R> {

  private static final Duration SAMPLE = Duration.ofMillis(100);

  /** Maximum delay of readings, real seconds. */
  private static final double DELAY = 0.3;

  /** Real time within which the simulation writes a line. */
  private static final Duration TRUTH_TIMEOUT = Duration.ofSeconds(30);

  /** Real time after the search within which faults must be over. */
  private static final Duration FAULT_TIMEOUT = Duration.ofSeconds(60);

  /** Maximum lateness of a cycle of the control loop, seconds, at real-time speed. */
  private static final double MAX_CYCLE_LATENESS = 0.010;

  private static final long LOOK_AGAIN_NANOS = 5_000_000;

  private final Scenario scenario;
  private final TruthSource source;
  private final TrueTrajectory truth = new TrueTrajectory();
  private final double speed;
  private final List<SearchingRobot<R>> robots;
  private final RunMeasurements figures;
  private final MissionProgressListener listener;
  private final InstantSource clock;
  private final LocalFrame field;
  private final GroundTruthClearance bodies;
  private final List<MissionEvent> marks = new ArrayList<>();

  /**
   * @param scenario the search
   * @param source of the robots' true poses
   * @param clock the robots' time
   * @param speed seconds of that per real second
   * @param robots in the order in which they are started
   * @param figures receives the measurements
   * @param listener receives the progress
   */
  public MissionMonitor(
      Scenario scenario,
      TruthSource source,
      InstantSource clock,
      double speed,
      List<SearchingRobot<R>> robots,
      RunMeasurements figures,
      MissionProgressListener listener) {
    this.scenario = scenario;
    this.source = source;
    this.clock = clock;
    this.speed = speed;
    this.robots = List.copyOf(robots);
    this.figures = figures;
    this.listener = listener;
    this.field = new LocalFrame(scenario.world().datum());
    this.bodies = new GroundTruthClearance(scenario.world());
  }

  /**
   * Monitors them to the end.
   *
   * @param faults faults to inject
   * @param longest timeout of the search, robots' time
   * @throws Exception if it cannot be monitored to its end; the message names the cause
   */
  public MissionResult run(List<InjectedFault<R>> faults, Duration longest) throws Exception {
    source.readNew(truth);
    Instant begin = clock.instant();
    for (int i = 0; i < robots.size(); i++) {
      robots.get(i).recorder().begin(begin);
      GoalSubmission.submit(
          robots.get(i).search(),
          new RasterGoal(
              scenario.region().corners(), scenario.swath(), scenario.spacing(), i % 2 == 1));
    }
    FaultInjectionContext<R> scene =
        new FaultInjectionContext<>(robots, truth, clock, speed, begin, field, figures, this::note);
    try {
      return follow(scene, faults, begin.plus(longest));
    } finally {
      faults.forEach(InjectedFault::close);
      robots.forEach(each -> each.subscriptions().close());
    }
  }

  private void note(MissionEvent mark) {
    marks.add(mark);
    listener.onEvent(mark);
  }

  private MissionResult follow(
      FaultInjectionContext<R> scene, List<InjectedFault<R>> faults, Instant latest)
      throws Exception {
    Instant now = scene.begin();
    do {
      now = now.plus(SAMPLE);
      awaitTruth(now.plus(Duration.ofNanos((long) (DELAY * speed * 1e9))));
      look(scene, faults);
      sample(scene, now);
    } while (anyUnderWay() && now.isBefore(latest));
    awaitFaultsDone(scene, faults);
    for (SearchingRobot<R> each : robots) {
      figures.add(
          new MeasuredValue(
              each.name() + ": lateness of 99 % of the control loop's last turns (real time)",
              each.lateness() / speed,
              speed == 1 ? MAX_CYCLE_LATENESS : Double.POSITIVE_INFINITY,
              "s"));
    }
    return flight(scene, now);
  }

  private void look(FaultInjectionContext<R> scene, List<InjectedFault<R>> faults)
      throws Exception {
    for (InjectedFault<R> each : faults) {
      if (!each.isOver()) {
        each.update(scene);
      }
    }
  }

  /**
   * Faults that have started run to their end, after all searches have ended. A fault that does not
   * end in time is reported with the search's measurements, which are kept.
   */
  private void awaitFaultsDone(FaultInjectionContext<R> scene, List<InjectedFault<R>> faults)
      throws Exception {
    look(scene, faults);
    long end = System.nanoTime() + FAULT_TIMEOUT.toNanos();
    while (isAnyFaultOpen(faults) && System.nanoTime() - end < 0) {
      LockSupport.parkNanos(this, LOOK_AGAIN_NANOS);
      source.readNew(truth);
      look(scene, faults);
    }
    if (!faults.isEmpty()) {
      long missed = faults.stream().filter(each -> !each.isOver()).count();
      figures.add(
          new MeasuredValue(
              "injected faults that did not occur, or were not repaired", missed, 0, ""));
    }
  }

  private boolean isAnyFaultOpen(List<InjectedFault<R>> faults) {
    return faults.stream().anyMatch(each -> each.hasStarted() && !each.isOver());
  }

  private void awaitTruth(Instant time) throws IOException, InterruptedException {
    Instant known = truth.latestTime();
    long end = System.nanoTime() + TRUTH_TIMEOUT.toNanos();
    source.readNew(truth);
    while (truth.latestTime().isBefore(time)) {
      if (System.nanoTime() - end > 0) {
        throw new IOException("the simulated world stopped at " + known);
      }
      LockSupport.parkNanos(this, LOOK_AGAIN_NANOS); // it does not report its own progress
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      source.readNew(truth);
    }
  }

  private void sample(FaultInjectionContext<R> scene, Instant now) throws IOException {
    Map<String, GroundTruthPose> poses = truth.at(now);
    List<MissionProgressListener.RobotProgress> all = new ArrayList<>();
    for (SearchingRobot<R> each : robots) {
      each.subscriptions().deliverUntil(now);
      GroundTruthPose pose = Objects.requireNonNull(poses.get(each.name()));
      LocalPosition at =
          each.plan()
              .region()
              .frame()
              .toLocal(field.toGeo(new LocalPosition(pose.east(), pose.north(), 0)));
      all.add(
          each.recorder()
              .sample(
                  new RobotLog.GroundTruth(
                      FaultInjectionContext.seconds(scene.begin(), now),
                      at.east(),
                      at.north(),
                      pose.yaw(),
                      pose.speed(),
                      bodies.clearance(each.name(), poses)),
                  each.subscriptions().status()));
    }
    listener.onProgress(all);
  }

  private boolean anyUnderWay() {
    return !robots.stream().allMatch(SearchingRobot::hasEnded);
  }

  private MissionResult flight(FaultInjectionContext<R> scene, Instant now) {
    List<RobotMissionResult> flights = new ArrayList<>();
    for (SearchingRobot<R> each : robots) {
      flights.add(each.recorder().result(each.subscriptions().latestStatus()));
    }
    List<Collision> collisions = source.collisions();
    for (Collision each : collisions) {
      marks.add(
          new MissionEvent(
              FaultInjectionContext.seconds(scene.begin(), each.time()),
              each.robot(),
              "collided with " + each.other()));
    }
    marks.sort(Comparator.comparingDouble(MissionEvent::time));
    return new MissionResult(
        flights, collisions, marks, FaultInjectionContext.seconds(scene.begin(), now));
  }

  /** A source of the robots' true poses while they search. */
  public interface TruthSource {

    /**
     * Reads the poses since the last call.
     *
     * @throws IOException if there will be no more; the message names the cause
     */
    void readNew(TrueTrajectory way) throws IOException;

    /** Collisions of robots in order of time, except those of the last second. */
    List<Collision> collisions();
  }

  /**
   * A fault injected during the search. Confined to the thread that monitors the search.
   *
   * @param <R> the runtime of a robot
   */
  public interface InjectedFault<R> extends AutoCloseable {

    /** No fault. */
    static <R> InjectedFault<R> none() {
      return new InjectedFault<>() {
        @Override
        public void update(FaultInjectionContext<R> now) {}

        @Override
        public boolean hasStarted() {
          return false;
        }

        @Override
        public boolean isOver() {
          return true;
        }
      };
    }

    /**
     * Checks whether to inject the fault, or its consequences; called ten times a second until it
     * is over. Returns quickly.
     */
    void update(FaultInjectionContext<R> now) throws Exception;

    /** Whether the fault has been injected. */
    boolean hasStarted();

    /** Whether the fault and its consequences are over, or it cannot occur any more. */
    boolean isOver();

    @Override
    default void close() {}
  }
}
