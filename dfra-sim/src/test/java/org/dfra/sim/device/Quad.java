package org.dfra.sim.device;

import java.time.Duration;
import java.time.Instant;
import org.dfra.sim.physics.MulticopterPhysics;
import org.jspecify.annotations.Nullable;

/** A body that flies in straight lines at the commanded speed, up to 8 m/s. For tests. */
final class Quad implements MulticopterPhysics {

  private static final double FASTEST = 8;

  private double east;
  private double north;
  private double up;
  private double goalEast;
  private double goalNorth;
  private double goalUp;
  private double speed;
  private boolean rotors;
  private @Nullable Instant last;

  @Override
  public synchronized void rotors(Instant time, boolean turn) {
    move(time);
    if (turn || up == 0) {
      rotors = turn;
      stay();
    }
  }

  @Override
  public synchronized void fly(
      Instant time, double toEast, double toNorth, double toUp, double fast) {
    move(time);
    if (rotors) {
      goalEast = toEast;
      goalNorth = toNorth;
      goalUp = toUp;
      speed = Math.min(fast, FASTEST);
    }
  }

  @Override
  public synchronized MulticopterState at(Instant time) {
    move(time);
    double far = left();
    double part = far == 0 ? 0 : speed / far;
    double eastward = (goalEast - east) * part;
    double northward = (goalNorth - north) * part;
    double yaw = eastward == 0 && northward == 0 ? 0 : Math.atan2(northward, eastward);
    return new MulticopterState(
        east, north, up, yaw, eastward, northward, (goalUp - up) * part, rotors);
  }

  private void move(Instant time) {
    if (last != null && time.isAfter(last)) {
      double step = speed * Duration.between(last, time).toNanos() / 1e9;
      double far = left();
      double part = far <= step ? 1 : step / far;
      east += (goalEast - east) * part;
      north += (goalNorth - north) * part;
      up += (goalUp - up) * part;
    }
    if (last == null || time.isAfter(last)) {
      last = time;
    }
  }

  private double left() {
    return Math.hypot(Math.hypot(goalEast - east, goalNorth - north), goalUp - up);
  }

  private void stay() {
    goalEast = east;
    goalNorth = north;
    goalUp = up;
  }
}
