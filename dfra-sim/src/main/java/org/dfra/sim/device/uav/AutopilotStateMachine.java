package org.dfra.sim.device.uav;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware.Mode;
import org.dfra.sim.physics.BatteryPhysics;
import org.dfra.sim.physics.MulticopterPhysics;
import org.dfra.sim.physics.MulticopterPhysics.MulticopterState;
import org.jspecify.annotations.Nullable;

/**
 * State machine of the autopilot's flight behaviour.
 *
 * <pre>
 *   disarmed --arm, checks passed--&gt; armed --take off--&gt; TAKE_OFF --high enough--&gt; HOLD | GUIDED
 *      ^                               |                                            |  ^
 *      +--10 s on the ground-----------+       reposition --&gt; GUIDED (PX4: HOLD) ---+  |
 *      +--2 s after touching down-- LAND &lt;--land, above home-- RETURN &lt;--return home--+
 *
 *   in the air, ground station lost --&gt; HOLD --after a while--&gt; RETURN
 * </pre>
 *
 * <p>Confined to one thread.
 */
final class AutopilotStateMachine {

  static final int ACCEPTED = 0;
  static final int REJECTED_FOR_NOW = 1;
  static final int DENIED = 2;
  static final int UNSUPPORTED = 3;
  static final int FAILED = 4;

  private static final double GROUND = 0.05; // metres
  private static final double NEAR = 0.5; // metres
  private static final double SPEED = 5; // metres per second, default
  private static final double DESCENT = 1.5; // metres per second
  private static final double LOW_BATTERY = 0.15;
  private static final double FARTHEST = 5000; // metres from home
  private static final Duration IDLE = Duration.ofSeconds(10);
  private static final Duration LANDED_DISARM_DELAY = Duration.ofSeconds(2);

  private final AutopilotSettings settings;
  private final LocalFrame world;
  private final MulticopterPhysics body;
  private final BatteryPhysics battery;
  private final GroundStationMonitor station;
  private final List<String> texts = new ArrayList<>();

  private Mode mode = Mode.MANUAL;
  private boolean armed;
  private boolean descending;
  private double goalEast;
  private double goalNorth;
  private double goalUp;
  private double speed = SPEED;
  private double homeEast;
  private double homeNorth;
  private @Nullable Instant groundedSince;

  AutopilotStateMachine(
      AutopilotSettings settings,
      LocalFrame world,
      MulticopterPhysics body,
      BatteryPhysics battery) {
    this.settings = settings;
    this.world = world;
    this.body = body;
    this.battery = battery;
    this.station = new GroundStationMonitor(settings);
  }

  Mode mode() {
    return mode;
  }

  boolean isArmed() {
    return armed;
  }

  /** Whether the failsafe is active: the ground station is lost. */
  boolean isMissingStation() {
    return station.isMissed();
  }

  /** {@code MAV_LANDED_STATE}. */
  int landed(MulticopterState flight) {
    if (mode == Mode.TAKE_OFF) {
      return 3;
    }
    if (flight.up() < GROUND) {
      return 1;
    }
    return descending ? 4 : 2;
  }

  /** Status texts since the last call. */
  List<String> texts() {
    List<String> pendingTexts = List.copyOf(texts);
    texts.clear();
    return pendingTexts;
  }

  /** A heartbeat of the ground station was received. */
  void heartbeat(Instant time) {
    station.heartbeat(time);
  }

  /** Advances the time. */
  void step(Instant time) {
    MulticopterState flight = body.at(time);
    checkGroundStation(flight, time);
    switch (mode) {
      case TAKE_OFF -> {
        if (flight.up() >= goalUp - NEAR) {
          mode = settings.software() == AutopilotSoftware.PX4 ? Mode.HOLD : Mode.GUIDED;
        }
      }
      case RETURN -> goHome(flight, time);
      default -> {}
    }
    checkLanding(flight, time);
  }

  private void goHome(MulticopterState flight, Instant time) {
    if (descending) {
      return;
    }
    if (Math.hypot(flight.east() - homeEast, flight.north() - homeNorth) < NEAR) {
      descend(homeEast, homeNorth, time);
    } else if (flight.up() >= goalUp - NEAR && (goalEast != homeEast || goalNorth != homeNorth)) {
      fly(homeEast, homeNorth, goalUp, time);
    }
  }

  private void checkGroundStation(MulticopterState flight, Instant time) {
    if (!armed || flight.up() < GROUND) {
      return;
    }
    switch (station.step(time)) {
      case LOST -> {
        texts.add("Failsafe: no ground station, holding");
        if (!descending && mode != Mode.RETURN) {
          hold(Mode.HOLD, time);
        }
      }
      case RETURN_DUE -> {
        texts.add("Failsafe: no ground station, returning");
        if (mode != Mode.RETURN && mode != Mode.LAND) {
          int unused = goBack(time);
        }
      }
      case NONE -> {}
    }
  }

  private void checkLanding(MulticopterState flight, Instant time) {
    if (!armed || flight.up() >= GROUND || mode == Mode.TAKE_OFF) {
      groundedSince = null;
      return;
    }
    if (groundedSince == null) {
      groundedSince = time;
    }
    Duration patience = descending ? LANDED_DISARM_DELAY : IDLE;
    if (Duration.between(groundedSince, time).compareTo(patience) >= 0) {
      disarmed(time);
    }
  }

  private void disarmed(Instant time) {
    armed = false;
    descending = false;
    body.rotors(time, false);
    texts.add("Disarmed");
  }

  /** Disarms, on the ground only. */
  int disarm(Instant time) {
    if (!armed) {
      return ACCEPTED;
    }
    if (body.at(time).up() >= GROUND || mode == Mode.TAKE_OFF) {
      texts.add("Disarming denied: not landed");
      return notNow();
    }
    disarmed(time);
    return ACCEPTED;
  }

  /** Arms. */
  int arm(boolean hasFix, Instant time) {
    if (armed) {
      return ACCEPTED;
    }
    String fault = fault(hasFix, time);
    if (fault != null) {
      texts.add("PreArm: " + fault);
      return notNow();
    }
    armed = true;
    descending = false;
    speed = SPEED;
    homeEast = body.at(time).east();
    homeNorth = body.at(time).north();
    body.rotors(time, true);
    return ACCEPTED;
  }

  private @Nullable String fault(boolean hasFix, Instant time) {
    if (!hasFix) {
      return "GPS: no 3D fix";
    }
    if (battery.at(time).remaining() < LOW_BATTERY) {
      return "battery low";
    }
    return mode == Mode.LAND || mode == Mode.RETURN ? "mode not armable" : null;
  }

  private int notNow() {
    return settings.software() == AutopilotSoftware.PX4 ? REJECTED_FOR_NOW : FAILED;
  }

  /**
   * Takes off.
   *
   * @param height in this software's frame, metres
   */
  int takeOff(double height, Instant time) {
    MulticopterState flight = body.at(time);
    boolean px4 = settings.software() == AutopilotSoftware.PX4;
    double up =
        px4 ? height + settings.separation() - world.datum().height() : flight.up() + height;
    if (!armed || flight.up() >= GROUND || (!px4 && mode != Mode.GUIDED)) {
      return notNow();
    }
    if (!(up > flight.up() + NEAR)) {
      return DENIED;
    }
    mode = Mode.TAKE_OFF;
    descending = false;
    fly(flight.east(), flight.north(), up, time);
    return ACCEPTED;
  }

  /**
   * Flies to a position.
   *
   * @param height above mean sea level, metres
   * @param requested metres per second; 0 or negative for the set speed
   * @param changesMode whether it may change the flight mode
   */
  int reposition(
      double latitude,
      double longitude,
      double height,
      double requested,
      boolean changesMode,
      Instant time) {
    if (body.at(time).up() < GROUND || !armed || (!changesMode && mode != Mode.GUIDED)) {
      return DENIED;
    }
    if (!(Math.abs(latitude) <= 90 && Math.abs(longitude) <= 180 && Double.isFinite(height))) {
      return DENIED;
    }
    LocalPosition there =
        world.toLocal(new GeoPosition(latitude, longitude, height + settings.separation()));
    if (!(there.up() > 0)
        || Math.hypot(there.east() - homeEast, there.north() - homeNorth) > FARTHEST) {
      texts.add("Reposition denied: outside the fence");
      return DENIED;
    }
    if (settings.software() == AutopilotSoftware.PX4) {
      speed = requested > 0 ? requested : SPEED;
      mode = Mode.HOLD;
    } else {
      mode = Mode.GUIDED; // its speed is another command
    }
    descending = false;
    fly(there.east(), there.north(), there.up(), time);
    return ACCEPTED;
  }

  /** Sets the flight speed, metres per second. */
  int changeSpeed(double requested, Instant time) {
    if (!(requested > 0)) {
      return DENIED;
    }
    speed = requested;
    if (armed && body.at(time).up() >= GROUND && !descending) {
      fly(goalEast, goalNorth, goalUp, time);
    }
    return ACCEPTED;
  }

  /** Sets a mode by its number. */
  int set(int number, boolean hasFix, Instant time) {
    for (Mode each : new Mode[] {Mode.GUIDED, Mode.HOLD, Mode.RETURN, Mode.LAND, Mode.MANUAL}) {
      if (settings.software().number(each) == number) {
        return set(each, hasFix, time);
      }
    }
    return DENIED;
  }

  private int set(Mode requested, boolean hasFix, Instant time) {
    if (requested == Mode.RETURN) {
      return goBack(time);
    }
    if (requested == Mode.LAND) {
      return land(time);
    }
    if (requested != Mode.MANUAL && !hasFix) {
      texts.add("Mode change failed: requires position");
      return notNow();
    }
    if (requested == Mode.GUIDED && mode == Mode.GUIDED) {
      return ACCEPTED;
    }
    // PX4 has one number for both; it holds its position until commanded
    hold(
        settings.software() == AutopilotSoftware.PX4 && requested == Mode.GUIDED
            ? Mode.HOLD
            : requested,
        time);
    return ACCEPTED;
  }

  private void hold(Mode as, Instant time) {
    mode = as;
    descending = false;
    MulticopterState flight = body.at(time);
    if (flight.up() >= GROUND) {
      fly(flight.east(), flight.north(), flight.up(), time);
    }
  }

  /** Lands at the current position. */
  int land(Instant time) {
    if (!armed) {
      return notNow();
    }
    mode = Mode.LAND;
    MulticopterState flight = body.at(time);
    descend(flight.east(), flight.north(), time);
    return ACCEPTED;
  }

  /** Returns home and lands. */
  int goBack(Instant time) {
    MulticopterState flight = body.at(time);
    if (!armed || flight.up() < GROUND) {
      return notNow();
    }
    mode = Mode.RETURN;
    descending = false;
    speed = SPEED;
    fly(flight.east(), flight.north(), Math.max(flight.up(), settings.returnHeight()), time);
    return ACCEPTED;
  }

  private void descend(double east, double north, Instant time) {
    descending = true;
    body.fly(time, east, north, 0, DESCENT);
  }

  private void fly(double east, double north, double up, Instant time) {
    goalEast = east;
    goalNorth = north;
    goalUp = up;
    body.fly(time, east, north, up, speed);
  }
}
