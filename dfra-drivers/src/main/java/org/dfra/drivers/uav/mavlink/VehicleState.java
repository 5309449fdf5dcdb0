package org.dfra.drivers.uav.mavlink;

import java.time.Instant;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.ExtendedState;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.GlobalPosition;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.GpsRaw;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Heartbeat;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.VfrHud;
import org.dfra.flow.effector.FlightState;
import org.dfra.flow.effector.FlightState.Phase;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * What the vehicle has told of its flight, put together. Heights above mean sea level become
 * heights above the ellipsoid by the geoid's height at this place:
 *
 * <pre>
 *   height above the ellipsoid = height above mean sea level + separation
 *   separation                 = GPS_RAW_INT.alt_ellipsoid − GPS_RAW_INT.alt, of a 3-D fix
 * </pre>
 *
 * <p>The separation changes by centimetres in a kilometre, so the last one counts while the vehicle
 * is there. Safe for use by several threads.
 */
final class VehicleState {

  /** How old a position may be, nanoseconds. */
  private static final long LONGEST_AGE = 3_000_000_000L;

  private static final int MAV_STATE_STANDBY = 3;

  private @Nullable Heartbeat heartbeat; // this and all that follows: guarded by this
  private @Nullable GlobalPosition position;
  private long positionNanos;
  private @Nullable VfrHud motion;
  private long motionNanos;
  private int landed;
  private int vehicle; // the last one found
  private @Nullable Double reportedSeparation;
  private @Nullable Double fixed;
  private Instant lastUpdate = Instant.EPOCH;

  /**
   * Goes by this separation and not by what the vehicle tells.
   *
   * @param separation of geoid and ellipsoid, metres, + where the geoid is above; null for what the
   *     vehicle tells
   */
  synchronized void overrideSeparation(@Nullable Double separation) {
    fixed = separation;
  }

  /** The separation that counts now; null where it is not known. */
  synchronized @Nullable Double separation() {
    return fixed == null ? reportedSeparation : fixed;
  }

  /** The vehicle is lost; where the geoid is there is still known when it comes back. */
  synchronized void forget() {
    heartbeat = null;
    position = null;
    motion = null;
    landed = 0;
  }

  /** This vehicle is found; another one may be anywhere. */
  synchronized void vehicleFound(Vehicle now) {
    if (vehicle != now.system()) {
      reportedSeparation = null;
    }
    vehicle = now.system();
  }

  /**
   * Takes what the vehicle says.
   *
   * @param time when it came, UTC
   * @param nanos the same by the ticker
   */
  synchronized void update(MavlinkMessage message, Instant time, long nanos) {
    lastUpdate = time;
    if (message instanceof Heartbeat now) {
      heartbeat = now;
    } else if (message instanceof GlobalPosition now) {
      position = now;
      positionNanos = nanos;
    } else if (message instanceof VfrHud now) {
      motion = now;
      motionNanos = nanos;
    } else if (message instanceof ExtendedState now) {
      landed = now.landed();
    } else if (message instanceof GpsRaw raw && raw.fixType() >= 3 && raw.height() != null) {
      reportedSeparation = raw.height() - raw.heightMsl();
    }
  }

  /** Whether there is enough to tell how it flies. */
  synchronized boolean isComplete() {
    return heartbeat != null && position != null;
  }

  /** What it is in the middle of, by its own mode. */
  synchronized boolean isInMode(FlightMode mode, Vehicle vehicle) {
    return heartbeat != null && mode.isReportedBy(vehicle, heartbeat.mode());
  }

  /** Whether its motors may turn. */
  synchronized boolean isArmed() {
    return heartbeat != null && heartbeat.isArmed();
  }

  /** What it does. */
  synchronized Phase phase() {
    return switch (landed) {
      case 1 -> Phase.ON_GROUND;
      case 2 -> Phase.IN_AIR;
      case 3 -> Phase.TAKING_OFF;
      case 4 -> Phase.LANDING;
      default -> // some autopilots do not tell
          heartbeat == null || !heartbeat.isArmed() || heartbeat.status() == MAV_STATE_STANDBY
              ? Phase.ON_GROUND
              : Phase.IN_AIR;
    };
  }

  /** Where it is, by its own estimate; null where that is too old, or it has none. */
  synchronized @Nullable GlobalPosition position(long nanos) {
    boolean counts =
        position != null
            && nanos - positionNanos <= LONGEST_AGE
            && (position.latitude() != 0 || position.longitude() != 0); // both 0 is no position
    return counts ? position : null;
  }

  /**
   * How it flies, at the time when something of it was last heard; null while too little is known.
   *
   * @param nanos the time by the ticker
   */
  synchronized @Nullable FlightState state(long nanos) {
    GlobalPosition last = position;
    if (heartbeat == null || last == null) {
      return null;
    }
    @Nullable GlobalPosition now = position(nanos);
    @Nullable VfrHud moved = motion != null && nanos - motionNanos <= LONGEST_AGE ? motion : null;
    @Nullable Double separation = separation();
    double home = last.heightMsl() - last.heightAboveHome();
    return new FlightState(
        lastUpdate,
        phase(),
        isArmed(),
        now == null || separation == null
            ? null
            : new GeoPosition(now.latitude(), now.longitude(), now.heightMsl() + separation),
        now == null && moved != null ? moved.heightMsl() - home : last.heightAboveHome(),
        heading(last, moved),
        moved == null ? Math.hypot(last.north(), last.east()) : moved.speed(),
        moved == null ? 0 - last.down() : moved.climb());
  }

  private static double heading(GlobalPosition last, @Nullable VfrHud moved) {
    if (last.heading() != null) {
      return last.heading();
    }
    return moved == null ? 0 : moved.heading();
  }
}
