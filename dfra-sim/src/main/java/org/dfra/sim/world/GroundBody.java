package org.dfra.sim.world;

import java.util.Optional;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.noise.Draws;
import org.dfra.sim.world.noise.Drift;
import org.jspecify.annotations.Nullable;

/**
 * The body of a skid-steered robot. Its wheels go after what they are told, each side by itself,
 * and its body after its wheels, less what they slip. Without a drive it stands.
 *
 * <p>The sides go {@code speed ∓ turnRate · track/2}, where the track is the effective one: turning
 * on the spot drags the wheels sideways, as if they were farther apart than they are. Where one
 * side would have to go faster than it can, both are slowed down alike, which keeps the curve.
 */
final class GroundBody extends Body {

  static final int DISTANCE = 0;
  static final int TURN = 1;
  static final int SPEED = 2;
  static final int TURN_RATE = 3;
  static final int DRIVE_WIDTH = 4;

  /** How a side without power slows down, metres per second squared. */
  private static final double COASTING = 1;

  final int driveOffset;

  private final @Nullable Wheels wheels;

  GroundBody(VehicleDescription vehicle, int index, Surroundings around) {
    super(vehicle, index, around);
    Optional<DeviceDescription> drive = vehicle.device(DeviceKind.DRIVE);
    this.driveOffset = around.slots().take(DRIVE_WIDTH);
    this.wheels =
        drive.isEmpty() ? null : new Wheels(vehicle, drive.get(), draws.of(drive.get().name()));
  }

  /** Takes a command; it acts from the next step on. */
  void drive(double speed, double turnRate, double acceleration, double turnAcceleration) {
    if (wheels != null) {
      wheels.want(speed, turnRate, acceleration, turnAcceleration);
    }
  }

  /** Sets or releases the brakes. */
  void brake(boolean set) {
    if (wheels != null) {
      wheels.braked = set;
    }
  }

  @Override
  void move(long next) {
    Wheels moving = wheels;
    if (moving == null) {
      return;
    }
    double speedBefore = moving.speed();
    double rateBefore = moving.turnRate();
    moving.turn(isPowered());
    double distance = (speedBefore + moving.speed()) / 2 * World.STEP_SECONDS;
    double angle = (rateBefore + moving.turnRate()) / 2 * World.STEP_SECONDS;
    if (distance == 0 && angle == 0) {
      eastward = 0;
      northward = 0;
      rate = 0;
      return;
    }
    distance *= 1 - moving.slip.at(next);
    angle *= 1 - moving.turnSlip.at(next);
    double half = angle / 2;
    double middle = yaw + half;
    // The chord of an arc, by the first terms of sin(half)/half: half is below 0.1.
    double chord = distance * (1 - half * half / 6 * (1 - half * half / 20));
    boolean unused =
        go(
            east + chord * StrictMath.cos(middle),
            north + chord * StrictMath.sin(middle),
            0,
            yaw + angle,
            next);
  }

  @Override
  double power() {
    return wheels == null || battery == null
        ? 0
        : battery.motion * Math.abs(wheels.speed()) + battery.turning * Math.abs(wheels.turnRate());
  }

  @Override
  boolean isOnGround() {
    return true;
  }

  @Override
  void write(double[] row) {
    super.write(row);
    if (wheels != null) {
      wheels.write(row, driveOffset);
    }
  }

  /** The two sides, what they are told and what their encoders count. */
  private static final class Wheels {

    private final double track;
    private final double fastest;
    private final double quickest;
    private final double brakes;
    private final double leftScale;
    private final double rightScale;
    final Slip slip;
    final Slip turnSlip;

    private boolean braked;
    private double wantedSpeed;
    private double wantedRate;
    private double acceleration = Double.POSITIVE_INFINITY;
    private double turnAcceleration = Double.POSITIVE_INFINITY;
    private double left; // metres per second
    private double right;
    private double leftWay; // metres, as counted
    private double rightWay;

    Wheels(VehicleDescription vehicle, DeviceDescription drive, Draws draws) {
      track = drive.parameter("effective_track", vehicle.type());
      fastest = drive.parameter("max_wheel_speed", vehicle.type());
      quickest = drive.parameter("max_acceleration", vehicle.type());
      brakes = drive.parameter("brake", vehicle.type());
      double noise = drive.parameter("encoder_noise", vehicle.type());
      Draws encoders = draws.of("encoders");
      leftScale =
          1 + drive.parameter("encoder_left", vehicle.type()) + noise * encoders.gaussian(0);
      rightScale =
          1 + drive.parameter("encoder_right", vehicle.type()) + noise * encoders.gaussian(1);
      double time = drive.parameter("slip_time", vehicle.type());
      slip =
          new Slip(
              drive.parameter("slip", vehicle.type()),
              Drift.gaussMarkov(
                  draws.of("slip"),
                  drive.parameter("slip_noise", vehicle.type()),
                  time,
                  World.STEP_SECONDS));
      turnSlip =
          new Slip(
              drive.parameter("turn_slip", vehicle.type()),
              Drift.gaussMarkov(
                  draws.of("turn_slip"),
                  drive.parameter("turn_slip_noise", vehicle.type()),
                  time,
                  World.STEP_SECONDS));
    }

    void want(double speed, double rate, double speedChange, double rateChange) {
      double fasterSide = Math.abs(speed) + Math.abs(rate) * track / 2;
      double share = fasterSide > fastest ? fastest / fasterSide : 1;
      wantedSpeed = speed * share;
      wantedRate = rate * share;
      acceleration = speedChange;
      turnAcceleration = rateChange;
    }

    void turn(boolean isPowered) {
      double leftBefore = left;
      double rightBefore = right;
      if (braked || !isPowered) {
        double most = (braked ? brakes : COASTING) * World.STEP_SECONDS;
        left = towards(left, 0, most);
        right = towards(right, 0, most);
      } else {
        double speed = towards(speed(), wantedSpeed, acceleration * World.STEP_SECONDS);
        double rate = towards(turnRate(), wantedRate, turnAcceleration * World.STEP_SECONDS);
        double most = quickest * World.STEP_SECONDS;
        left = towards(left, speed - rate * track / 2, most);
        right = towards(right, speed + rate * track / 2, most);
      }
      leftWay += leftScale * (leftBefore + left) / 2 * World.STEP_SECONDS;
      rightWay += rightScale * (rightBefore + right) / 2 * World.STEP_SECONDS;
    }

    double speed() {
      return (left + right) / 2;
    }

    double turnRate() {
      return (right - left) / track;
    }

    void write(double[] row, int offset) {
      row[offset + DISTANCE] = (leftWay + rightWay) / 2;
      row[offset + TURN] = (rightWay - leftWay) / track;
      row[offset + SPEED] = (leftScale * left + rightScale * right) / 2;
      row[offset + TURN_RATE] = (rightScale * right - leftScale * left) / track;
    }
  }

  /** The part of the wheels' way that the body lags behind. */
  private record Slip(double mean, Drift noise) {
    double at(long step) {
      return mean + noise.at(step);
    }
  }
}
