package org.dfra.behaviors.perceptual.pose;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;
import org.dfra.behaviors.perceptual.pose.FilterInput.MotionIncrement;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.Odometry;
import org.jspecify.annotations.Nullable;

/** Dead reckoning with its associated fixes. */
final class DeadReckoning {

  /** Timeout of motion increments, nanoseconds. */
  private static final long SILENT = EpochNanos.SECOND;

  /** Unmeasured distance after which older fixes are useless for the position, metres. */
  private static final double ASTRAY = 0.5;

  private static final int MOST_WAITING = 16;

  private final MotionIncrementBuilder steps;
  private final DeadReckoningTrack track;
  private final FixWindow window;
  private final List<LocalFix> waiting = new ArrayList<>();

  DeadReckoning(TrackerSettings settings) {
    this.steps = new MotionIncrementBuilder(settings.wheels());
    this.track = new DeadReckoningTrack(settings.gyro());
    this.window = new FixWindow(settings);
  }

  void take(AngularRate rate) {
    steps.take(rate);
  }

  /** The motion increment from this reading; null if none. */
  @Nullable MotionIncrement take(Odometry odometry) {
    return add(steps.take(odometry));
  }

  /** An unmeasured increment to a time, if the wheels sent no data for long; else null. */
  @Nullable MotionIncrement advanceTo(long time) {
    if (!steps.hasBegun()) {
      return add(steps.unmeasured(time));
    }
    return time - steps.time() > SILENT ? add(steps.unmeasured(time)) : null;
  }

  private @Nullable MotionIncrement add(@Nullable MotionIncrement step) {
    if (step == null) {
      if (steps.hasBegun() && !track.covers(steps.time())) {
        track.begin(steps.time());
      }
      return null;
    }
    track.add(step);
    if (step.isClockJump()) {
      waiting.clear();
    }
    if (step.isClockJump() || step.distanceSigma() > ASTRAY) {
      window.clear();
    }
    for (LocalFix fix : List.copyOf(waiting)) {
      if (fix.time() <= steps.time()) {
        waiting.remove(fix);
        place(fix);
      }
    }
    return step;
  }

  /** Associates a fix with the track, at once or when the track has reached its time. */
  void add(LocalFix fix) {
    if (fix.time() <= steps.time()) {
      place(fix);
    } else if (waiting.size() < MOST_WAITING) {
      waiting.add(fix);
    }
  }

  private void place(LocalFix fix) {
    if (track.covers(fix.time())) {
      double rate = yawRate();
      window.add(fix, track.at(fix.time()), steps.speed(), rate);
    }
  }

  /**
   * Yaw rate, radians per second, to the left is +; from the gyro minus its bias, else from the
   * wheels.
   */
  double yawRate() {
    double rate = steps.gyroYawRate();
    return Double.isNaN(rate) ? steps.wheelYawRate() : rate - track.gyroBias();
  }

  MotionIncrementBuilder steps() {
    return steps;
  }

  DeadReckoningTrack track() {
    return track;
  }

  FixWindow window() {
    return window;
  }

  /** Alignment of the track in the map; empty before the first associated fix. */
  Optional<Alignment> align() {
    return window.align();
  }

  /** The pose on the track at a time, extrapolated from its end for half a second at most. */
  DeadReckoningTrack.Pose predict(long time) {
    DeadReckoningTrack.Pose end = track.end();
    if (time <= steps.time()) {
      return end;
    }
    MotionIncrement step = steps.extrapolate(time);
    double dt = Math.min(0.5, step.seconds());
    double turn =
        step.hasGyro() ? step.gyroYaw() - track.gyroBias() * step.seconds() : yawRate() * dt;
    double middle = end.yaw() + turn / 2;
    return new DeadReckoningTrack.Pose(
        end.x() + step.distance() * Math.cos(middle),
        end.y() + step.distance() * Math.sin(middle),
        end.yaw() + turn);
  }
}
