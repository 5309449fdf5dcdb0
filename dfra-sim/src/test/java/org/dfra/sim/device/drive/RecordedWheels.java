package org.dfra.sim.device.drive;

import java.time.Instant;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.sim.physics.DrivetrainPhysics;
import org.dfra.sim.physics.IdealDrivetrain;
import org.jspecify.annotations.Nullable;

/** Wheels on blocks, and the commands of the controller. */
final class RecordedWheels implements DrivetrainPhysics {

  /** Slower is standing: a wheel of 0.155 m turns by less than a degree in a second. */
  private static final double STANDING = 1e-3;

  /** One command that they received. */
  record Order(Instant time, double speed, double turnRate) {

    boolean moves() {
      return Math.abs(speed) > STANDING || Math.abs(turnRate) > STANDING;
    }
  }

  final List<Order> orders = new CopyOnWriteArrayList<>();
  private final IdealDrivetrain wheels;

  RecordedWheels(Instant begin) {
    wheels = new IdealDrivetrain(begin);
  }

  @Override
  public void drive(
      Instant time, double speed, double turnRate, double acceleration, double turnAcceleration) {
    orders.add(new Order(time, speed, turnRate));
    wheels.drive(time, speed, turnRate, acceleration, turnAcceleration);
  }

  @Override
  public void brake(Instant time, boolean set) {
    wheels.brake(time, set);
  }

  @Override
  public Travel travel(Instant time) {
    return wheels.travel(time);
  }

  /** See {@link IdealDrivetrain#stoppedSince}. */
  @Nullable Instant standingSince(Instant time) {
    return wheels.stoppedSince(time);
  }

  boolean stand(Instant time) {
    return standingSince(time) != null;
  }
}
