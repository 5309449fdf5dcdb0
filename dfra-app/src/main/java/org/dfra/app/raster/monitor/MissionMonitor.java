package org.dfra.app.raster.monitor;

import java.io.IOException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.locks.LockSupport;
import org.dfra.app.measurement.MeasuredValue;
import org.dfra.app.measurement.RunMeasurements;
import org.dfra.app.raster.ClearanceCalculator;
import org.dfra.app.raster.MissionEvent;
import org.dfra.app.raster.MissionListener;
import org.dfra.app.raster.MissionResult;
import org.dfra.app.raster.MissionResult.RobotMissionResult;
import org.dfra.app.raster.RobotLog;
import org.dfra.app.raster.Scenario;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.world.Collision;
import org.dfra.sim.world.GroundTruthPose;

/**
 * Tells robots to search, and follows them: ten times a second of their time it notes where each
 * truly is and what it had told by then, and looks whether something is to go wrong. Confined to
 * one thread.
 *
 * @param <R> what runs a robot
 */
public final class MissionMonitor<R> {

  private static final Duration SAMPLE = Duration.ofMillis(100);

  /** After which what was told of a moment has come, real seconds. */
  private static final double DELAY = 0.3;

  /** Real time in which the simulation writes something. */
  private static final Duration TRUTH_TIMEOUT = Duration.ofSeconds(30);

  /** Real time in which troubles are to be over after the search is. */
  private static final Duration FAULT_TIMEOUT = Duration.ofSeconds(60);

  /** What a turn of the control loop may be late, seconds, where time goes as it really does. */
  private static final double MAX_CYCLE_LATENESS = 0.010;

  private static final long LOOK_AGAIN_NANOS = 5_000_000;

  private final Scenario scenario;
  private final TruthSource source;
  private final TrueTrajectory truth = new TrueTrajectory();
  private final double speed;
  private final List<SearchingRobot<R>> robots;
  private final RunMeasurements figures;
  private final MissionListener listener;
  private final InstantSource clock;
  private final LocalFrame field;
  private final ClearanceCalculator bodies;
  private final List<MissionEvent> marks = new ArrayList<>();

  /**
   * @param scenario what is searched
   * @param source tells where the robots truly are
   * @param clock the robots' time
   * @param speed seconds of that in a real second
   * @param robots in the order in which they are told to search
   * @param figures takes what is measured
   * @param listener is told how it goes on
   */
  public MissionMonitor(
      Scenario scenario,
      TruthSource source,
      InstantSource clock,
      double speed,
      List<SearchingRobot<R>> robots,
      RunMeasurements figures,
      MissionListener listener) {
    this.scenario = scenario;
    this.source = source;
    this.clock = clock;
    this.speed = speed;
    this.robots = List.copyOf(robots);
    this.figures = figures;
    this.listener = listener;
    this.field = new LocalFrame(scenario.world().datum());
    this.bodies = new ClearanceCalculator(scenario.world());
  }

  /**
   * Follows them to the end.
   *
   * @param troubles what goes wrong on the way
   * @param longest robots' time after which the search is given up
   * @throws Exception if it cannot be followed to its end; the message says why
   */
  public MissionResult run(List<InjectedFault<R>> troubles, Duration longest) throws Exception {
    source.readNew(truth);
    Instant begin = clock.instant();
    for (int i = 0; i < robots.size(); i++) {
      robots.get(i).recorder().begin(begin);
      submit(
          robots.get(i).search(),
          new RasterGoal(
              scenario.region().corners(), scenario.swath(), scenario.spacing(), i % 2 == 1));
    }
    MissionContext<R> scene =
        new MissionContext<>(robots, truth, clock, speed, begin, field, figures, this::note);
    try {
      return follow(scene, troubles, begin.plus(longest));
    } finally {
      troubles.forEach(InjectedFault::close);
      robots.forEach(each -> each.subscriptions().close());
    }
  }

  /**
   * Submits a goal. Nobody else commands the demonstration's robots, so one that pursues a goal
   * after a lost answer pursues this one; one that does not is asked once more.
   */
  private static void submit(RasterSearch search, RasterGoal goal) throws RemoteException {
    try {
      var unused = search.pursue(goal);
    } catch (RemoteException e) {
      if (!search.status().phase().isUnderWay()) {
        var unused = search.pursue(goal);
      }
    }
  }

  private void note(MissionEvent mark) {
    marks.add(mark);
    listener.onEvent(mark);
  }

  private MissionResult follow(
      MissionContext<R> scene, List<InjectedFault<R>> troubles, Instant latest) throws Exception {
    Instant now = scene.begin();
    do {
      now = now.plus(SAMPLE);
      awaitTruth(now.plus(Duration.ofNanos((long) (DELAY * speed * 1e9))));
      look(scene, troubles);
      sample(scene, now);
    } while (anyUnderWay() && now.isBefore(latest));
    awaitFaultsDone(scene, troubles);
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

  private void look(MissionContext<R> scene, List<InjectedFault<R>> troubles) throws Exception {
    for (InjectedFault<R> each : troubles) {
      if (!each.isOver()) {
        each.update(scene);
      }
    }
  }

  /**
   * What has begun to go wrong comes to its end, though nobody searches any more. What has not by
   * then is told with the search's figures, which stand.
   */
  private void awaitFaultsDone(MissionContext<R> scene, List<InjectedFault<R>> troubles)
      throws Exception {
    look(scene, troubles);
    long end = System.nanoTime() + FAULT_TIMEOUT.toNanos();
    while (isAnyFaultOpen(troubles) && System.nanoTime() - end < 0) {
      LockSupport.parkNanos(this, LOOK_AGAIN_NANOS);
      source.readNew(truth);
      look(scene, troubles);
    }
    if (!troubles.isEmpty()) {
      long missed = troubles.stream().filter(each -> !each.isOver()).count();
      figures.add(
          new MeasuredValue("troubles that did not come, or were not mended", missed, 0, ""));
    }
  }

  private boolean isAnyFaultOpen(List<InjectedFault<R>> troubles) {
    return troubles.stream().anyMatch(each -> each.hasStarted() && !each.isOver());
  }

  private void awaitTruth(Instant time) throws IOException, InterruptedException {
    Instant known = truth.latestTime();
    long end = System.nanoTime() + TRUTH_TIMEOUT.toNanos();
    source.readNew(truth);
    while (truth.latestTime().isBefore(time)) {
      if (System.nanoTime() - end > 0) {
        throw new IOException("the simulated world stands still at " + known);
      }
      LockSupport.parkNanos(this, LOOK_AGAIN_NANOS); // it tells nobody that it goes on
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      source.readNew(truth);
    }
  }

  private void sample(MissionContext<R> scene, Instant now) throws IOException {
    Map<String, GroundTruthPose> poses = truth.at(now);
    List<MissionListener.RobotProgress> all = new ArrayList<>();
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
                      MissionContext.seconds(scene.begin(), now),
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

  private MissionResult flight(MissionContext<R> scene, Instant now) {
    List<RobotMissionResult> flights = new ArrayList<>();
    for (SearchingRobot<R> each : robots) {
      flights.add(each.recorder().result(each.subscriptions().latestStatus()));
    }
    List<Collision> collisions = source.collisions();
    for (Collision each : collisions) {
      marks.add(
          new MissionEvent(
              MissionContext.seconds(scene.begin(), each.time()),
              each.robot(),
              "ran into " + each.other()));
    }
    marks.sort(Comparator.comparingDouble(MissionEvent::time));
    return new MissionResult(
        flights, collisions, marks, MissionContext.seconds(scene.begin(), now));
  }
}
