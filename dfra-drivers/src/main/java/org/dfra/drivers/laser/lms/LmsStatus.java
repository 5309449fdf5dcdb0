package org.dfra.drivers.laser.lms;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * {@code B1}: what the laser tells of itself.
 *
 * @param software version of its software, such as {@code V02.30}
 * @param operatingMode what it does: 24 hex streams scans, 25 hex waits to be asked, 0 installs
 * @param isDefective whether it has a defect
 * @param pollution of the front window, channel by channel, per cent of what a clean one had; 100
 *     where the laser has not been calibrated
 * @param revolutions of its mirror, 0 to 65 535, counted anew at power-on
 * @param amplitude of the laser's light, per cent of what it had when it was calibrated
 * @param modeCode its measuring mode
 * @param variant where its beams are; empty for one that nobody knows
 * @param unit what it counts distances in; empty for one that nobody knows
 * @param baud the speed of its line; empty for one that nobody knows
 * @param isLaserOff whether its light is off
 * @param status how it is
 */
public record LmsStatus(
    String software,
    int operatingMode,
    boolean isDefective,
    List<Integer> pollution,
    int revolutions,
    int amplitude,
    int modeCode,
    Optional<LmsVariant> variant,
    Optional<LmsUnit> unit,
    Optional<LmsBaud> baud,
    boolean isLaserOff,
    StatusByte status)
    implements LmsMessage.Telegram {

  public LmsStatus {
    pollution = List.copyOf(pollution);
  }

  @Override
  public String name() {
    return "B1";
  }

  /** Whether a robot can rely on it. */
  public boolean isSound() {
    return !isDefective && !isLaserOff && status.isSound();
  }

  /** In a sentence. */
  public String inWords() {
    return String.format(
        Locale.ROOT,
        "software %s, %s%s, window at %s %% of clean, light at %d %%, %s",
        software,
        isDefective ? "defective, " : "",
        isLaserOff ? "laser off" : "laser on",
        pollution.isEmpty() ? "?" : pollution.stream().min(Integer::compare).orElse(0),
        amplitude,
        status.inWords());
  }
}
