package org.dfra.sim.world;

import java.util.Optional;
import org.dfra.sim.world.VehicleBody.BodyContext;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.noise.CorrelatedNoise;
import org.dfra.sim.world.noise.RandomStream;
import org.jspecify.annotations.Nullable;

/**
 * The body of a skid-steered robot. Each side's wheels follow their command, and the body follows
 * the wheels less their slip. Without a drive it is stationary.
 *
 * <p>The sides go {@code speed ∓ turnRate · track/2}, where the track is the effective one:
 * rotation in place drags the wheels sideways, as if they were farther apart. Where one side would
 * exceed its maximum speed, both are scaled down equally, which keeps the curvature.
 */
final class SkidSteerBody extends VehicleBody {

  static final int DISTANCE = 0;
  static final int YAW = 1;
  static final int SPEED = 2;
  static final int YAW_RATE = 3;
  static final int DRIVE_WIDTH = 4;

  /** Deceleration of a side without power, metres per second squared. */
  private static final double COASTING = 1;

  final int driveOffset;

  private final @Nullable Wheels wheels;

  SkidSteerBody(VehicleDescription vehicle, int index, BodyContext around) {
    super(vehicle, index, around);
    Optional<DeviceDescription> drive = vehicle.device(DeviceKind.DRIVE);
    this.driveOffset = around.layout().allocate(DRIVE_WIDTH);
    this.wheels =
        drive.isEmpty()
            ? null
            : new Wheels(vehicle, drive.get(), draws.substream(drive.get().name()));
  }

  /** Accepts a command; it takes effect from the next step on. */
  void drive(double speed, double yawRate, double acceleration, double yawAcceleration) {
    if (wheels != null) {
      wheels.setTarget(speed, yawRate, acceleration, yawAcceleration);
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
    double rateBefore = moving.yawRate();
    moving.update(isPowered());
    double distance = (speedBefore + moving.speed()) / 2 * World.STEP_SECONDS;
    double angle = (rateBefore + moving.yawRate()) / 2 * World.STEP_SECONDS;
    if (distance == 0 && angle == 0) {
      eastward = 0;
      northward = 0;
      rate = 0;
      return;
    }
    distance *= 1 - moving.slip.at(next);
    angle *= 1 - moving.yawSlip.at(next);
    double half = angle / 2;
    double middle = yaw + half;
    // The chord of an arc, by the first terms of sin(half)/half: half is below 0.1.
    double chord = distance * (1 - half * half / 6 * (1 - half * half / 20));
    boolean unused =
        tryMove(
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
        : battery.motion * Math.abs(wheels.speed()) + battery.turning * Math.abs(wheels.yawRate());
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

  /** One side: its command and its encoder count. */
  private static final class Wheels {

    private final double track;
    private final double fastest;
    private final double quickest;
    private final double brakes;
    private final double leftScale;
    private final double rightScale;
    final Slip slip;
    final Slip yawSlip;

    private boolean braked;
    private double targetSpeed;
    private double targetYawRate;
    private double acceleration = Double.POSITIVE_INFINITY;
    private double yawAcceleration = Double.POSITIVE_INFINITY;
    private double left; // metres per second
    private double right;
    private double leftWay; // metres, as counted
    private double rightWay;

    Wheels(VehicleDescription vehicle, DeviceDescription drive, RandomStream draws) {
      track = drive.parameter("effective_track", vehicle.type());
      fastest = drive.parameter("max_wheel_speed", vehicle.type());
      quickest = drive.parameter("max_acceleration", vehicle.type());
      brakes = drive.parameter("brake_deceleration", vehicle.type());
      double noise = drive.parameter("encoder_scale_sigma", vehicle.type());
      RandomStream encoders = draws.substream("encoders");
      leftScale =
          1
              + drive.parameter("left_encoder_scale_error", vehicle.type())
              + noise * encoders.gaussian(0);
      rightScale =
          1
              + drive.parameter("right_encoder_scale_error", vehicle.type())
              + noise * encoders.gaussian(1);
      double time = drive.parameter("slip_correlation_time", vehicle.type());
      slip =
          new Slip(
              drive.parameter("slip", vehicle.type()),
              CorrelatedNoise.gaussMarkov(
                  draws.substream("slip"),
                  drive.parameter("slip_sigma", vehicle.type()),
                  time,
                  World.STEP_SECONDS));
      yawSlip =
          new Slip(
              drive.parameter("yaw_slip", vehicle.type()),
              CorrelatedNoise.gaussMarkov(
                  draws.substream("turn_slip"),
                  drive.parameter("yaw_slip_sigma", vehicle.type()),
                  time,
                  World.STEP_SECONDS));
    }

    void setTarget(double speed, double rate, double speedChange, double rateChange) {
      double fasterSide = Math.abs(speed) + Math.abs(rate) * track / 2;
      double share = fasterSide > fastest ? fastest / fasterSide : 1;
      targetSpeed = speed * share;
      targetYawRate = rate * share;
      acceleration = speedChange;
      yawAcceleration = rateChange;
    }

    void update(boolean isPowered) {
      double leftBefore = left;
      double rightBefore = right;
      if (braked || !isPowered) {
        double most = (braked ? brakes : COASTING) * World.STEP_SECONDS;
        left = stepTowards(left, 0, most);
        right = stepTowards(right, 0, most);
      } else {
        double speed = stepTowards(speed(), targetSpeed, acceleration * World.STEP_SECONDS);
        double rate = stepTowards(yawRate(), targetYawRate, yawAcceleration * World.STEP_SECONDS);
        double most = quickest * World.STEP_SECONDS;
        left = stepTowards(left, speed - rate * track / 2, most);
        right = stepTowards(right, speed + rate * track / 2, most);
      }
      leftWay += leftScale * (leftBefore + left) / 2 * World.STEP_SECONDS;
      rightWay += rightScale * (rightBefore + right) / 2 * World.STEP_SECONDS;
    }

    double speed() {
      return (left + right) / 2;
    }

    double yawRate() {
      return (right - left) / track;
    }

    void write(double[] row, int offset) {
      row[offset + DISTANCE] = (leftWay + rightWay) / 2;
      row[offset + YAW] = (rightWay - leftWay) / track;
      row[offset + SPEED] = (leftScale * left + rightScale * right) / 2;
      row[offset + YAW_RATE] = (rightScale * right - leftScale * left) / track;
    }
  }

  /** The fraction of the wheels' distance lost by slip. */
  private record Slip(double mean, CorrelatedNoise noise) {
    double at(long step) {
      return mean + noise.at(step);
    }
  }
}
