package org.dfra.drivers.laser.lms;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;

/**
 * {@code B1}: the laser's status report.
 *
 * @param software version of its software, such as {@code V02.30}
 * @param operatingMode 24 hex streams scans, 25 hex sends scans on request, 0 is installation mode
 * @param isDefective whether it has a defect
 * @param pollution of the front window, channel by channel, per cent of a clean window; 100 for a
 *     laser that has not been calibrated
 * @param revolutions of its mirror, 0 to 65 535, counted from power-on
 * @param amplitude of the laser's light, per cent of the calibrated value
 * @param modeCode its measuring mode
 * @param variant its field of view and resolution; empty if unknown
 * @param unit its unit of distance; empty if unknown
 * @param baud its baud rate; empty if unknown
 * @param isLaserOff whether its light is off
 * @param status its status byte
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

  /** Whether it is healthy. */
  public boolean isSound() {
    return !isDefective && !isLaserOff && status.isSound();
  }

  /** A human-readable sentence. */
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
