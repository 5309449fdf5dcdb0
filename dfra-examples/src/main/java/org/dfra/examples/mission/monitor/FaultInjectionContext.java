package org.dfra.examples.mission.monitor;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;

/**
 * A running search, as seen by injected faults. Confined to the thread that monitors it.
 *
 * @param <R> the runtime of a robot
 * @param robots in the order in which they were started
 * @param truth their true poses
 * @param clock the robots' time
 * @param speed seconds of that per real second
 * @param begin when the search began
 * @param field the world's frame
 * @param measurements receives the measurements
 * @param eventListener receives the events
 */
public record FaultInjectionContext<R>(
    List<SearchingRobot<R>> robots,
    TrueTrajectory truth,
    InstantSource clock,
    double speed,
    Instant begin,
    LocalFrame field,
    RunMeasurements measurements,
    Consumer<MissionEvent> eventListener) {

  public FaultInjectionContext {
    robots = List.copyOf(robots);
  }

  /** Records and reports an event of a robot; the format is {@link String#format}'s. */
  public void recordEvent(
      Instant when, SearchingRobot<R> robot, String format, Object... arguments) {
    String what = String.format(Locale.ROOT, format, arguments);
    eventListener.accept(new MissionEvent(seconds(begin, when), robot.name(), what));
  }

  /** Records a time limit that applies on every computer, in seconds. */
  public void requirement(String what, double seconds, double most) {
    measurements.add(new MeasuredValue(what, seconds, most, "s").asRequired());
  }

  /** Records a measured time, in real seconds. */
  public void figure(String what, double seconds, double most) {
    measurements.add(new MeasuredValue(what, seconds, most, "s"));
  }

  /** A robot's current true position, in the frame of its region. */
  public LocalPosition truePosition(SearchingRobot<R> robot) throws IOException {
    GroundTruthPose pose = truth.last(robot.name());
    return robot
        .plan()
        .region()
        .frame()
        .toLocal(field.toGeo(new LocalPosition(pose.east(), pose.north(), 0)));
  }

  /** Time from one moment to another, seconds of the robots' time. */
  public static double seconds(Instant from, Instant to) {
    return Duration.between(from, to).toNanos() / 1e9;
  }
}
