package org.dfra.drivers.uav.mavlink;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import io.dronefleet.mavlink.common.MavCmd;
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
 * Combines the vehicle's messages into its flight state. Heights above mean sea level are converted
 * to heights above the ellipsoid with the local height of the geoid:
 *
 * <pre>
 *   height above the ellipsoid = height above mean sea level + separation
 *   separation                 = GPS_RAW_INT.alt_ellipsoid − GPS_RAW_INT.alt, of a 3-D fix
 * </pre>
 *
 * <p>The separation changes by centimetres per kilometre, so the last value stays valid while the
 * vehicle is connected. Safe for use by several threads.
 */
final class VehicleState {

  /** Maximum age of a position, nanoseconds. */
  private static final long LONGEST_AGE = 3_000_000_000L;

  private static final int MAV_STATE_STANDBY = 3;

  @GuardedBy("this")
  private @Nullable Heartbeat heartbeat;

  @GuardedBy("this")
  private @Nullable GlobalPosition position;

  @GuardedBy("this")
  private long positionNanos;

  @GuardedBy("this")
  private @Nullable VfrHud motion;

  @GuardedBy("this")
  private long motionNanos;

  @GuardedBy("this")
  private int landed;

  // ID of the last vehicle found
  @GuardedBy("this")
  private int vehicle;

  @GuardedBy("this")
  private @Nullable Double reportedSeparation;

  @GuardedBy("this")
  private @Nullable Double fixed;

  @GuardedBy("this")
  private Instant lastUpdate = Instant.EPOCH;

  /**
   * Uses this separation instead of the reported one.
   *
   * @param separation of geoid and ellipsoid, metres, + where the geoid is above; null for the
   *     reported one
   */
  synchronized void overrideSeparation(@Nullable Double separation) {
    fixed = separation;
  }

  /** The current separation; null if unknown. */
  synchronized @Nullable Double separation() {
    return fixed == null ? reportedSeparation : fixed;
  }

  /** The vehicle is lost; the separation is kept for when it returns. */
  synchronized void forget() {
    heartbeat = null;
    position = null;
    motion = null;
    landed = 0;
  }

  /** A vehicle is found; the separation of another vehicle is discarded. */
  synchronized void vehicleFound(Vehicle now) {
    if (vehicle != now.system()) {
      reportedSeparation = null;
    }
    vehicle = now.system();
  }

  /**
   * Updates the state from a message.
   *
   * @param time time of arrival, UTC
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

  /** Whether enough is known for a flight state. */
  synchronized boolean isComplete() {
    return heartbeat != null && position != null;
  }

  /** Whether the vehicle reports this flight mode. */
  synchronized boolean isInMode(FlightMode mode, Vehicle vehicle) {
    return heartbeat != null && mode.isReportedBy(vehicle, heartbeat.mode());
  }

  /** Whether its motors may turn. */
  synchronized boolean isArmed() {
    return heartbeat != null && heartbeat.isArmed();
  }

  /** The phase of flight. */
  synchronized Phase phase() {
    return switch (landed) {
      case 1 -> Phase.ON_GROUND;
      case 2 -> Phase.IN_AIR;
      case 3 -> Phase.TAKING_OFF;
      case 4 -> Phase.LANDING;
      default -> // some autopilots do not report it
          heartbeat == null || !heartbeat.isArmed() || heartbeat.status() == MAV_STATE_STANDBY
              ? Phase.ON_GROUND
              : Phase.IN_AIR;
    };
  }

  /** Its own position estimate; null if it is too old or missing. */
  synchronized @Nullable GlobalPosition position(long nanos) {
    boolean counts =
        position != null
            && nanos - positionNanos <= LONGEST_AGE
            && (position.latitude() != 0 || position.longitude() != 0); // both 0 is no position
    return counts ? position : null;
  }

  /**
   * The flight state at the time of the last message; null while too little is known.
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

  /**
   * Flight modes of an autopilot, with its own numbers. Source: the flight modes of ArduCopter
   * ({@code COPTER_MODE}) and the main and sub modes of PX4.
   */
  enum FlightMode {
    /** Holds its position, without a pilot: BRAKE, AUTO.LOITER. */
    HOLD(17, 4, 3),
    /** Flies to commanded positions: GUIDED; PX4 does so in its hold mode. */
    GUIDED(4, 4, 3),
    /** Flies back and lands: RTL, AUTO.RTL. */
    RETURN(6, 4, 5),
    /** Lands: LAND, AUTO.LAND. */
    LAND(9, 4, 6);

    /** Base mode: the custom mode is the autopilot's own. */
    private static final int CUSTOM = 1;

    private final int arduPilot;
    private final int main;
    private final int sub;

    FlightMode(int arduPilot, int main, int sub) {
      this.arduPilot = arduPilot;
      this.main = main;
      this.sub = sub;
    }

    /** The command that sets it. */
    MavlinkCommand set(Vehicle vehicle) {
      return vehicle.autopilot() == Vehicle.ARDUPILOT
          ? MavlinkCommand.CommandLong.of(MavCmd.MAV_CMD_DO_SET_MODE, CUSTOM, arduPilot)
          : new MavlinkCommand.CommandLong(
              MavCmd.MAV_CMD_DO_SET_MODE, CUSTOM, main, sub, 0, 0, 0, 0);
    }

    /** Whether a heartbeat with this mode reports it. */
    boolean isReportedBy(Vehicle vehicle, long mode) {
      return mode
          == (vehicle.autopilot() == Vehicle.ARDUPILOT
              ? arduPilot
              : (long) sub << 24 | (long) main << 16);
    }
  }
}
