package org.dfra.behaviors.perceptual.pose;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.Odometry;
import org.jspecify.annotations.Nullable;

/** Dead reckoning and the fixes beside it. */
final class Reckoning {

  /** Steps that do not come for this long do not come, nanoseconds. */
  private static final long SILENT = Ticks.SECOND;

  /** Metres of unmeasured way after which older fixes say nothing of the place. */
  private static final double ASTRAY = 0.5;

  private static final int MOST_WAITING = 16;

  private final Steps steps;
  private final Track track;
  private final FixWindow window;
  private final List<LocalFix> waiting = new ArrayList<>();

  Reckoning(TrackerSettings settings) {
    this.steps = new Steps(settings.wheels());
    this.track = new Track(settings.gyro());
    this.window = new FixWindow(settings);
  }

  void take(AngularRate rate) {
    steps.take(rate);
  }

  /** The step that this reading makes; null if none. */
  @Nullable Step take(Odometry odometry) {
    return add(steps.take(odometry));
  }

  /** The step to a time, blindly, where the wheels have long been silent then; else null. */
  @Nullable Step catchUp(long time) {
    if (!steps.hasBegun()) {
      return add(steps.blind(time));
    }
    return time - steps.time() > SILENT ? add(steps.blind(time)) : null;
  }

  private @Nullable Step add(@Nullable Step step) {
    if (step == null) {
      if (steps.hasBegun() && !track.covers(steps.time())) {
        track.begin(steps.time());
      }
      return null;
    }
    track.add(step);
    if (step.isBreach()) {
      waiting.clear();
    }
    if (step.isBreach() || step.lostWay() > ASTRAY) {
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

  /** Takes a fix beside the track, at once or when the track has come so far. */
  void add(LocalFix fix) {
    if (fix.time() <= steps.time()) {
      place(fix);
    } else if (waiting.size() < MOST_WAITING) {
      waiting.add(fix);
    }
  }

  private void place(LocalFix fix) {
    if (track.covers(fix.time())) {
      double rate = turnRate();
      window.add(fix, track.at(fix.time()), steps.speed(), rate);
    }
  }

  /** To the left, radians per second; by the gyro less its bias at rest, else by the wheels. */
  double turnRate() {
    double rate = steps.gyroRate();
    return Double.isNaN(rate) ? steps.wheelRate() : rate - track.bias();
  }

  Steps steps() {
    return steps;
  }

  Track track() {
    return track;
  }

  FixWindow window() {
    return window;
  }

  /** How the track lies in the map; empty before the first fix beside it. */
  Optional<Alignment> align() {
    return window.align();
  }

  /** The pose on the track at a time, from where it ends, for half a second at most. */
  Track.Pose ahead(long time) {
    Track.Pose end = track.end();
    if (time <= steps.time()) {
      return end;
    }
    Step step = steps.ahead(time);
    double dt = Math.min(0.5, step.seconds());
    double turn =
        step.hasGyro() ? step.gyroTurn() - track.bias() * step.seconds() : turnRate() * dt;
    double middle = end.yaw() + turn / 2;
    return new Track.Pose(
        end.x() + step.way() * Math.cos(middle),
        end.y() + step.way() * Math.sin(middle),
        end.yaw() + turn);
  }
}
