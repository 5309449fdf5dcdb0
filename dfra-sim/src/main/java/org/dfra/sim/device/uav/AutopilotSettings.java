package org.dfra.sim.device.uav;

import java.time.Duration;
import org.jspecify.annotations.Nullable;

/**
 * What an emulated autopilot is set to. Immutable.
 *
 * @param software what flies it
 * @param vehicle its number, 1 to 255
 * @param baud bits per second of its line
 * @param separation height of the geoid above the ellipsoid at its place, metres
 * @param timeToFirstFix how long after it was switched on it looks for satellites
 * @param groundStationTimeout how long without a heartbeat of the ground station it flies on
 * @param returnDelay how long it then holds its place before it returns home
 * @param returnHeight at which it returns at least, metres above home
 * @param commandFaults how it answers otherwise than it should
 */
public record AutopilotSettings(
    AutopilotSoftware software,
    int vehicle,
    int baud,
    double separation,
    Duration timeToFirstFix,
    Duration groundStationTimeout,
    Duration returnDelay,
    double returnHeight,
    CommandFaults commandFaults) {

  /** For tests of those who command it: a refusal, a deaf moment. Asked by the device's thread. */
  @FunctionalInterface
  public interface CommandFaults {

    /** The answer that is none: as if the command had not arrived. */
    int NO_ANSWER = -1;

    /** None. */
    CommandFaults NONE = (command, confirmation) -> null;

    /**
     * How a command is answered; it is not done then.
     *
     * @param command {@code MAV_CMD}
     * @param confirmation how often it was sent before, as it says
     * @return {@code MAV_RESULT} or {@link #NO_ANSWER}; null to do the command as usual
     */
    @Nullable Integer answer(int command, int confirmation);
  }

  public AutopilotSettings {
    if (vehicle < 1 || vehicle > 255) {
      throw new IllegalArgumentException("vehicle " + vehicle + " is outside 1 to 255");
    }
  }

  /**
   * As usual: vehicle 1 on a line of 921 600 baud, a fix at once, 5 s without the ground station
   * until it holds its place, 10 s more until it returns, 15 m above home.
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

  /** The same with such whims. */
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
}
