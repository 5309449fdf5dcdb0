package org.dfra.app.raster.live;

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
import org.dfra.app.figure.Figure;
import org.dfra.app.figure.Figures;
import org.dfra.app.raster.Bodies;
import org.dfra.app.raster.Flight;
import org.dfra.app.raster.Flight.RobotFlight;
import org.dfra.app.raster.Mark;
import org.dfra.app.raster.MissionListener;
import org.dfra.app.raster.RobotLog;
import org.dfra.app.raster.Scenario;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.world.Collision;
import org.dfra.sim.world.TruePose;

/**
 * Tells robots to search, and follows them: ten times a second of their time it notes where each
 * truly is and what it had told by then, and looks whether something is to go wrong. Confined to
 * one thread.
 *
 * @param <R> what runs a robot
 */
public final class Watch<R> {

  private static final Duration SAMPLE = Duration.ofMillis(100);

  /** After which what was told of a moment has come, real seconds. */
  private static final double DELAY = 0.3;

  /** Real time in which the simulation writes something. */
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  /** Real time in which troubles are to be over after the search is. */
  private static final Duration AFTERMATH = Duration.ofSeconds(60);

  /** What a turn of the control loop may be late, seconds, where time goes as it really does. */
  private static final double JITTER = 0.010;

  private static final long LOOK_AGAIN_NANOS = 5_000_000;

  private final Scenario scenario;
  private final TruthSource source;
  private final TrueWay truth = new TrueWay();
  private final double speed;
  private final List<Searching<R>> robots;
  private final Figures figures;
  private final MissionListener listener;
  private final InstantSource clock;
  private final LocalFrame field;
  private final Bodies bodies;
  private final List<Mark> marks = new ArrayList<>();

  /**
   * @param scenario what is searched
   * @param source tells where the robots truly are
   * @param clock the robots' time
   * @param speed seconds of that in a real second
   * @param robots in the order in which they are told to search
   * @param figures takes what is measured
   * @param listener is told how it goes on
   */
  public Watch(
      Scenario scenario,
      TruthSource source,
      InstantSource clock,
      double speed,
      List<Searching<R>> robots,
      Figures figures,
      MissionListener listener) {
    this.scenario = scenario;
    this.source = source;
    this.clock = clock;
    this.speed = speed;
    this.robots = List.copyOf(robots);
    this.figures = figures;
    this.listener = listener;
    this.field = new LocalFrame(scenario.world().datum());
    this.bodies = new Bodies(scenario.world());
  }

  /**
   * Follows them to the end.
   *
   * @param troubles what goes wrong on the way
   * @param longest robots' time after which the search is given up
   * @throws Exception if it cannot be followed to its end; the message says why
   */
  public Flight run(List<Trouble<R>> troubles, Duration longest) throws Exception {
    source.readOn(truth);
    Instant begin = clock.instant();
    for (int i = 0; i < robots.size(); i++) {
      robots.get(i).log().begin(begin);
      submit(
          robots.get(i).search(),
          new RasterGoal(
              scenario.region().corners(), scenario.swath(), scenario.spacing(), i % 2 == 1));
    }
    Scene<R> scene = new Scene<>(robots, truth, clock, speed, begin, field, figures, this::note);
    try {
      return follow(scene, troubles, begin.plus(longest));
    } finally {
      troubles.forEach(Trouble::close);
      robots.forEach(each -> each.hearing().close());
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

  private void note(Mark mark) {
    marks.add(mark);
    listener.happened(mark);
  }

  private Flight follow(Scene<R> scene, List<Trouble<R>> troubles, Instant latest)
      throws Exception {
    Instant now = scene.begin();
    do {
      now = now.plus(SAMPLE);
      awaitTruth(now.plus(Duration.ofNanos((long) (DELAY * speed * 1e9))));
      look(scene, troubles);
      sample(scene, now);
    } while (anyUnderWay() && now.isBefore(latest));
    seeTheEnd(scene, troubles);
    for (Searching<R> each : robots) {
      figures.add(
          new Figure(
              each.name() + ": lateness of 99 % of the control loop's last turns (real time)",
              each.lateness() / speed,
              speed == 1 ? JITTER : Double.POSITIVE_INFINITY,
              "s"));
    }
    return flight(scene, now);
  }

  private void look(Scene<R> scene, List<Trouble<R>> troubles) throws Exception {
    for (Trouble<R> each : troubles) {
      if (!each.isOver()) {
        each.look(scene);
      }
    }
  }

  /**
   * What has begun to go wrong comes to its end, though nobody searches any more. What has not by
   * then is told with the search's figures, which stand.
   */
  private void seeTheEnd(Scene<R> scene, List<Trouble<R>> troubles) throws Exception {
    look(scene, troubles);
    long end = System.nanoTime() + AFTERMATH.toNanos();
    while (isAnyUnmended(troubles) && System.nanoTime() - end < 0) {
      LockSupport.parkNanos(this, LOOK_AGAIN_NANOS);
      source.readOn(truth);
      look(scene, troubles);
    }
    if (!troubles.isEmpty()) {
      long missed = troubles.stream().filter(each -> !each.isOver()).count();
      figures.add(new Figure("troubles that did not come, or were not mended", missed, 0, ""));
    }
  }

  private boolean isAnyUnmended(List<Trouble<R>> troubles) {
    return troubles.stream().anyMatch(each -> each.hasBegun() && !each.isOver());
  }

  private void awaitTruth(Instant time) throws IOException, InterruptedException {
    Instant known = truth.newest();
    long end = System.nanoTime() + PATIENCE.toNanos();
    source.readOn(truth);
    while (truth.newest().isBefore(time)) {
      if (System.nanoTime() - end > 0) {
        throw new IOException("the simulated world stands still at " + known);
      }
      LockSupport.parkNanos(this, LOOK_AGAIN_NANOS); // it tells nobody that it goes on
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      source.readOn(truth);
    }
  }

  private void sample(Scene<R> scene, Instant now) throws IOException {
    Map<String, TruePose> poses = truth.at(now);
    List<MissionListener.At> all = new ArrayList<>();
    for (Searching<R> each : robots) {
      each.hearing().release(now);
      TruePose pose = Objects.requireNonNull(poses.get(each.name()));
      LocalPosition at =
          each.plan()
              .region()
              .frame()
              .toLocal(field.toGeo(new LocalPosition(pose.east(), pose.north(), 0)));
      all.add(
          each.log()
              .sample(
                  new RobotLog.Truth(
                      Scene.seconds(scene.begin(), now),
                      at.east(),
                      at.north(),
                      pose.yaw(),
                      pose.speed(),
                      bodies.clearance(each.name(), poses)),
                  each.hearing().status()));
    }
    listener.at(all);
  }

  private boolean anyUnderWay() {
    return !robots.stream().allMatch(Searching::hasEnded);
  }

  private Flight flight(Scene<R> scene, Instant now) {
    List<RobotFlight> flights = new ArrayList<>();
    for (Searching<R> each : robots) {
      flights.add(each.log().flight(each.hearing().newest()));
    }
    List<Collision> collisions = source.collisions();
    for (Collision each : collisions) {
      marks.add(
          new Mark(
              Scene.seconds(scene.begin(), each.time()), each.robot(), "ran into " + each.other()));
    }
    marks.sort(Comparator.comparingDouble(Mark::time));
    return new Flight(flights, collisions, marks, Scene.seconds(scene.begin(), now));
  }
}
