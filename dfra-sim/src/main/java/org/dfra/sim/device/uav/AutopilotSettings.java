package org.dfra.sim.device.uav;

import java.time.Duration;
import org.jspecify.annotations.Nullable;

/**
 * Settings of an emulated autopilot. Immutable.
 *
 * @param software of the autopilot
 * @param vehicle its number, 1 to 255
 * @param baud bits per second of its serial line
 * @param separation height of the geoid above the ellipsoid at its place, metres
 * @param timeToFirstFix time from power-on to the first fix
 * @param groundStationTimeout how long it continues to fly without a heartbeat of the ground
 *     station
 * @param returnDelay how long it then holds its position before it returns home
 * @param returnHeight minimum height of the return, metres above home
 * @param commandFaults injected faults of command replies
 */
public record AutopilotSettings(
    AutopilotSettings.AutopilotSoftware software,
    int vehicle,
    int baud,
    double separation,
    Duration timeToFirstFix,
    Duration groundStationTimeout,
    Duration returnDelay,
    double returnHeight,
    CommandFaults commandFaults) {

  /**
   * For tests of command clients: injects rejections and missing replies. The device's thread calls
   * it.
   */
  @FunctionalInterface
  public interface CommandFaults {

    /** No reply: as if the command had not arrived. */
    int NO_ANSWER = -1;

    /** No faults. */
    CommandFaults NONE = (command, confirmation) -> null;

    /**
     * The reply to a command; the command is not executed then.
     *
     * @param command {@code MAV_CMD}
     * @param confirmation number of earlier transmissions, as the command reports it
     * @return {@code MAV_RESULT} or {@link #NO_ANSWER}; null to execute the command
     */
    @Nullable Integer answer(int command, int confirmation);
  }

  public AutopilotSettings {
    if (vehicle < 1 || vehicle > 255) {
      throw new IllegalArgumentException("vehicle " + vehicle + " is outside 1 to 255");
    }
  }

  /**
   * Defaults: vehicle 1 at 921 600 baud, a fix at once, 5 s without the ground station until it
   * holds its position, 10 s more until it returns, 15 m above home.
   */
  public static AutopilotSettings of(AutopilotSoftware software) {
    return new AutopilotSettings(
        software,
        1,
        921_600,
        -25.5,
        Duration.ZERO,
        Duration.ofSeconds(5),
        Duration.ofSeconds(10),
        15,
        CommandFaults.NONE);
  }

  /** The same with these command faults. */
  public AutopilotSettings with(CommandFaults other) {
    return new AutopilotSettings(
        software,
        vehicle,
        baud,
        separation,
        timeToFirstFix,
        groundStationTimeout,
        returnDelay,
        returnHeight,
        other);
  }

  /** The same with another time to its first fix. */
  public AutopilotSettings withTimeToFirstFix(Duration other) {
    return new AutopilotSettings(
        software,
        vehicle,
        baud,
        separation,
        other,
        groundStationTimeout,
        returnDelay,
        returnHeight,
        commandFaults);
  }

  /** The vehicle's autopilot software: the two differ in numbers and in behaviour. */
  public enum AutopilotSoftware {
    /**
     * Takes off to heights above mean sea level; replies TEMPORARILY_REJECTED to commands that it
     * cannot execute yet.
     */
    PX4(12, 0x010F04FF, 3 << 16, mode(3), mode(3), mode(2), mode(5), mode(6)),
    /**
     * Takes off to heights above home, in the mode GUIDED; replies FAILED to commands that it
     * cannot execute yet.
     */
    ARDUPILOT(3, 0x040600FF, 0, 17, 4, 4, 6, 9);

    /** Flight modes of the vehicle. */
    enum Mode {
      /** Manual control by a human pilot. */
      MANUAL,
      /** Holds its position. */
      HOLD,
      /** Flies to commanded positions. */
      GUIDED,
      /** Takes off. */
      TAKE_OFF,
      /** Returns home and lands. */
      RETURN,
      /** Lands. */
      LAND
    }

    private final int autopilot;
    private final int version;
    private final int[] modes;

    AutopilotSoftware(int autopilot, int version, int... modes) {
      this.autopilot = autopilot;
      this.version = version;
      this.modes = modes;
    }

    /** The number of one of PX4's automatic modes. */
    private static int mode(int sub) {
      return sub << 24 | 4 << 16;
    }

    /** {@code MAV_AUTOPILOT}. */
    int autopilot() {
      return autopilot;
    }

    /** Of {@code AUTOPILOT_VERSION}: major, minor, patch, release type; a byte each. */
    int version() {
      return version;
    }

    /** The number of a mode in {@code HEARTBEAT}. */
    int number(Mode mode) {
      return modes[mode.ordinal()];
    }
  }
}
