package org.dfra.sim.world;

import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.WorldDescription.WeatherDescription;
import org.dfra.sim.world.noise.RandomStream;
import org.dfra.sim.world.shape.MutableTransform;
import org.dfra.sim.world.shape.OrientedRectangle;
import org.jspecify.annotations.Nullable;

/**
 * The body of a robot: its pose, and its motion from one step to the next. In a row of the history
 * it has {@value #WIDTH} numbers of its own. Confined to the world's monitor.
 */
abstract class VehicleBody {

  static final int EAST = 0;
  static final int NORTH = 1;
  static final int UP = 2;
  static final int YAW = 3;
  static final int COS = 4;
  static final int SIN = 5;
  static final int ROLL = 6;
  static final int PITCH = 7;
  static final int EASTWARD = 8;
  static final int NORTHWARD = 9;
  static final int UPWARD = 10;
  static final int RATE = 11;
  static final int WIDTH = 12;

  final VehicleDescription vehicle;
  final int index;
  final int offset;
  final OrientedRectangle box; // current pose
  final @Nullable BatteryModel battery;
  final RandomStream draws;

  double east;
  double north;
  double up;
  double yaw;
  double cos;
  double sin;
  double eastward; // velocity over the last step
  double northward;
  double upward;
  double rate;

  private final Terrain terrain;
  private final CollisionDetector contacts;
  private final OrientedRectangle boxThen;

  VehicleBody(VehicleDescription vehicle, int index, BodyContext around) {
    this.vehicle = vehicle;
    this.index = index;
    this.offset = around.layout().allocate(WIDTH);
    this.terrain = around.terrain();
    this.contacts = around.collisions();
    this.draws = around.random().substream(vehicle.name());
    this.battery = BatteryModel.of(vehicle, around.layout());
    this.box = new OrientedRectangle(vehicle.length(), vehicle.width());
    this.boxThen = new OrientedRectangle(vehicle.length(), vehicle.width());
    this.east = vehicle.east();
    this.north = vehicle.north();
    setYaw(vehicle.yaw());
    box.move(east, north, cos, sin);
  }

  /** Advances it to the next step. */
  final void step(long next) {
    move(next);
    if (battery != null) {
      battery.drain(power());
    }
  }

  /** Advances it to the next step by its own dynamics. */
  abstract void move(long next);

  /** Watts of its motors, in addition to those of the stationary robot. */
  abstract double power();

  /** Whether it has power. */
  final boolean isPowered() {
    return battery == null || !battery.isEmpty();
  }

  /** Writes it to a row of the history. */
  void write(double[] row) {
    row[offset + EAST] = east;
    row[offset + NORTH] = north;
    row[offset + UP] = up;
    row[offset + YAW] = yaw;
    row[offset + COS] = cos;
    row[offset + SIN] = sin;
    row[offset + ROLL] = isOnGround() ? terrain.roll(east, north, cos, sin) : 0;
    row[offset + PITCH] = isOnGround() ? terrain.pitch(east, north, cos, sin) : 0;
    row[offset + EASTWARD] = eastward;
    row[offset + NORTHWARD] = northward;
    row[offset + UPWARD] = upward;
    row[offset + RATE] = rate;
    if (battery != null) {
      battery.write(row);
    }
  }

  /** Whether it is on the ground and tilts with it. */
  abstract boolean isOnGround();

  /** Pose at a step of its frame, at the centre of its base. */
  void transformAt(double[] row, MutableTransform out) {
    out.set(
        row[offset + EAST],
        row[offset + NORTH],
        row[offset + UP],
        row[offset + ROLL],
        row[offset + PITCH],
        row[offset + COS],
        row[offset + SIN]);
  }

  /** Its rectangle at a step; the next call overwrites it. */
  OrientedRectangle boxAt(double[] row) {
    boxThen.move(row[offset + EAST], row[offset + NORTH], row[offset + COS], row[offset + SIN]);
    return boxThen;
  }

  /**
   * Moves to a pose, as far as obstacles allow: with its rotation only, or with its translation
   * only, or not at all.
   *
   * @param toEast metres
   * @param toNorth metres
   * @param toUp metres above the ground
   * @param toYaw target yaw, radians
   * @return whether no obstacle was in the way
   */
  final boolean tryMove(double toEast, double toNorth, double toUp, double toYaw, long next) {
    double fromEast = east;
    double fromNorth = north;
    double fromUp = up;
    double fromYaw = yaw;
    boolean isFree = tryMoveTo(toEast, toNorth, toUp, toYaw, next, true);
    if (!isFree
        && !tryMoveTo(fromEast, fromNorth, fromUp, toYaw, next, false)
        && !tryMoveTo(toEast, toNorth, toUp, fromYaw, next, false)) {
      put(fromEast, fromNorth, fromUp, fromYaw);
    }
    eastward = (east - fromEast) / World.STEP_SECONDS;
    northward = (north - fromNorth) / World.STEP_SECONDS;
    upward = (up - fromUp) / World.STEP_SECONDS;
    rate = (yaw - fromYaw) / World.STEP_SECONDS;
    return isFree;
  }

  private boolean tryMoveTo(
      double toEast, double toNorth, double toUp, double toYaw, long next, boolean counts) {
    double wasEastward = (toEast - east) / World.STEP_SECONDS;
    double wasNorthward = (toNorth - north) / World.STEP_SECONDS;
    double wasUpward = (toUp - up) / World.STEP_SECONDS;
    double backEast = east;
    double backNorth = north;
    double backUp = up;
    double backYaw = yaw;
    put(toEast, toNorth, toUp, toYaw);
    int hit = contacts.findCollision(this);
    if (hit == CollisionDetector.NOTHING) {
      return true;
    }
    put(backEast, backNorth, backUp, backYaw);
    if (counts) {
      contacts.record(this, hit, next, wasEastward, wasNorthward, wasUpward);
    }
    return false;
  }

  private void put(double toEast, double toNorth, double toUp, double toYaw) {
    east = toEast;
    north = toNorth;
    up = toUp;
    setYaw(toYaw);
    box.move(east, north, cos, sin);
  }

  private void setYaw(double to) {
    if (to != yaw || cos == 0 && sin == 0) {
      yaw = to;
      cos = StrictMath.cos(to);
      sin = StrictMath.sin(to);
    }
  }

  /** Approaches a target value by at most the given change. */
  static double stepTowards(double from, double to, double most) {
    return Math.abs(to - from) <= most ? to : from + Math.copySign(most, to - from);
  }

  /**
   * The parts of the world that a body's constructor needs.
   *
   * @param random source of all random numbers in the world
   */
  record BodyContext(
      StateLayout layout,
      Terrain terrain,
      CollisionDetector collisions,
      WeatherDescription weather,
      RandomStream random) {}
}
