package org.dfra.sim.world;

import java.util.Optional;
import org.dfra.sim.world.VehicleBody.BodyContext;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.WorldDescription.WeatherDescription;
import org.dfra.sim.world.noise.CorrelatedNoise;
import org.dfra.sim.world.noise.RandomStream;
import org.jspecify.annotations.Nullable;

/**
 * The body of a multicopter under its autopilot: its target velocity leads straight to the
 * commanded position and allows it to stop there; it accelerates towards that velocity at its
 * limit. Gusts displace it. It leans against the steady wind, which costs power but does not move
 * it. Without an autopilot it stays on the ground.
 *
 * <pre>
 *   rotors off ----rotors(true)--&gt; on the ground --fly(up &gt; 0)--&gt; in the air
 *        ^                           |       ^                       |
 *        +-------rotors(false)-------+       +---fly(up = 0), lands--+
 * </pre>
 *
 * <p>With an empty battery it lands where it is and its rotors stop.
 */
final class MulticopterBody extends VehicleBody {

  static final int ROTORS = 0;
  static final int FLIGHT_WIDTH = 1;

  private static final double APPROACH = 1.2; // target speed per remaining distance, 1/s
  private static final double FOLLOW = 4; // acceleration per velocity error, 1/s
  private static final double NEAR_GROUND = 1; // metres: below, it descends slowly to land
  private static final double TOUCH_DOWN = 0.3; // metres per second
  private static final double NOSE_FOLLOWS_FROM = 0.5; // metres per second
  private static final double GUST_TIME = 3; // seconds of correlation

  final int flightOffset;

  private final @Nullable Autopilot autopilot;

  private MulticopterBody(
      VehicleDescription vehicle, int index, BodyContext around, @Nullable Autopilot autopilot) {
    super(vehicle, index, around);
    this.flightOffset = around.layout().allocate(FLIGHT_WIDTH);
    this.autopilot = autopilot;
  }

  static MulticopterBody of(VehicleDescription vehicle, int index, BodyContext around) {
    Optional<DeviceDescription> flight = vehicle.device(DeviceKind.FLIGHT);
    return new MulticopterBody(
        vehicle,
        index,
        around,
        flight.isEmpty() ? null : new Autopilot(vehicle, flight.get(), around));
  }

  /** The autopilot's state and targets. */
  private static final class Autopilot {
    private final double maxSpeed;
    private final double maxAcceleration;
    private final double maxClimb;
    private final double maxDescent;
    private final double maxYawRate;
    private final double gustResponse;
    private final CorrelatedNoise gustEastward;
    private final CorrelatedNoise gustNorthward;
    private final double windEastward;
    private final double windNorthward;

    private boolean rotors;
    private double toEast;
    private double toNorth;
    private double toUp;
    private double toSpeed;

    Autopilot(VehicleDescription vehicle, DeviceDescription flight, BodyContext around) {
      maxSpeed = flight.parameter("max_speed", vehicle.type());
      maxAcceleration = flight.parameter("max_acceleration", vehicle.type());
      maxClimb = flight.parameter("max_climb", vehicle.type());
      maxDescent = flight.parameter("max_descent", vehicle.type());
      maxYawRate = flight.parameter("max_yaw_rate", vehicle.type());
      gustResponse = flight.parameter("gust_response", vehicle.type());
      RandomStream gusts = around.random().substream(vehicle.name()).substream(flight.name());
      WeatherDescription weather = around.weather();
      windEastward = weather.windSpeed() * StrictMath.cos(weather.windTowards());
      windNorthward = weather.windSpeed() * StrictMath.sin(weather.windTowards());
      double sigma = weather.gustSigma();
      gustEastward =
          CorrelatedNoise.gaussMarkov(
              gusts.substream("eastward"), sigma, GUST_TIME, World.STEP_SECONDS);
      gustNorthward =
          CorrelatedNoise.gaussMarkov(
              gusts.substream("northward"), sigma, GUST_TIME, World.STEP_SECONDS);
    }
  }

  /** Starts or stops the rotors; in the air they cannot be stopped. */
  void rotors(boolean turn) {
    if (autopilot == null || turn == autopilot.rotors || up > 0) {
      return;
    }
    autopilot.rotors = turn;
    goal(autopilot, east, north, 0, TOUCH_DOWN);
  }

  /** Flies to a position; does nothing while the rotors are stopped. */
  void fly(double toEast, double toNorth, double toUp, double speed) {
    if (autopilot != null && autopilot.rotors) {
      goal(autopilot, toEast, toNorth, toUp, speed);
    }
  }

  private static void goal(
      Autopilot pilot, double toEast, double toNorth, double toUp, double speed) {
    pilot.toEast = toEast;
    pilot.toNorth = toNorth;
    pilot.toUp = Math.max(0, toUp);
    pilot.toSpeed = speed;
  }

  @Override
  void move(long next) {
    if (autopilot == null || !autopilot.rotors) {
      stop();
      return;
    }
    if (!isPowered()) {
      goal(autopilot, east, north, 0, autopilot.maxSpeed);
      autopilot.rotors = up > 0;
    }
    if (up == 0 && autopilot.toUp == 0) {
      stop();
      return;
    }
    fly(autopilot, next);
  }

  private void stop() {
    eastward = 0;
    northward = 0;
    upward = 0;
    rate = 0;
  }

  private void fly(Autopilot pilot, long next) {
    double dt = World.STEP_SECONDS;
    double x = pilot.toEast - east;
    double y = pilot.toNorth - north;
    double z = pilot.toUp - up;
    double level = Math.sqrt(x * x + y * y);
    double way = Math.sqrt(level * level + z * z);
    double share = way == 0 ? 0 : wantedSpeed(pilot, way, level, z) / way;
    double climb = landing(pilot, level, z * share);
    double ax = FOLLOW * (x * share - eastward);
    double ay = FOLLOW * (y * share - northward);
    double az = FOLLOW * (climb - upward);
    double a = Math.sqrt(ax * ax + ay * ay + az * az);
    double limit = a > pilot.maxAcceleration ? pilot.maxAcceleration / a : 1;
    double vx = eastward + (ax * limit + pilot.gustResponse * pilot.gustEastward.at(next)) * dt;
    double vy = northward + (ay * limit + pilot.gustResponse * pilot.gustNorthward.at(next)) * dt;
    double vz = upward + az * limit * dt;
    double nextUp = Math.max(0, up + vz * dt);
    boolean isFree =
        tryMove(east + vx * dt, north + vy * dt, nextUp, heading(pilot, vx, vy, dt), next);
    if (isFree && nextUp > 0) { // avoids the rounding error of displacement over time
      eastward = vx;
      northward = vy;
      upward = vz;
    } else if (up == 0) {
      stop();
    }
  }

  /** The speed along the straight line: within all limits, and slow enough to stop at its end. */
  private static double wantedSpeed(Autopilot pilot, double way, double level, double z) {
    double speed = Math.min(pilot.toSpeed, APPROACH * way);
    speed = Math.min(speed, Math.sqrt(pilot.maxAcceleration * way)); // half of its maximum
    if (level > 0) {
      speed = Math.min(speed, pilot.maxSpeed * way / level);
    }
    double vertical = z > 0 ? pilot.maxClimb : pilot.maxDescent;
    return z == 0 ? speed : Math.min(speed, vertical * way / Math.abs(z));
  }

  /** Target climb rate; near the ground, above the landing point, it keeps descending. */
  private double landing(Autopilot pilot, double level, double climb) {
    if (pilot.toUp > 0 || up > NEAR_GROUND || level > NEAR_GROUND) {
      return climb;
    }
    return -Math.min(pilot.maxDescent, Math.max(TOUCH_DOWN, up));
  }

  private double heading(Autopilot pilot, double vx, double vy, double dt) {
    if (vx * vx + vy * vy < NOSE_FOLLOWS_FROM * NOSE_FOLLOWS_FROM) {
      return yaw;
    }
    double turn = Math.IEEEremainder(StrictMath.atan2(vy, vx) - yaw, 2 * Math.PI);
    return yaw + Math.max(-pilot.maxYawRate * dt, Math.min(pilot.maxYawRate * dt, turn));
  }

  @Override
  double power() {
    if (battery == null || autopilot == null || !autopilot.rotors) {
      return 0;
    }
    if (up == 0) {
      return battery.hover / 4; // the rotors run without lift
    }
    double x = eastward - autopilot.windEastward;
    double y = northward - autopilot.windNorthward;
    return battery.hover + battery.motion * Math.sqrt(x * x + y * y + upward * upward);
  }

  @Override
  boolean isOnGround() {
    return up == 0;
  }

  @Override
  void write(double[] row) {
    super.write(row);
    row[flightOffset + ROTORS] = autopilot != null && autopilot.rotors ? 1 : 0;
  }
}
