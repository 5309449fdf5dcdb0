package org.dfra.drivers.laser.lms;

import java.util.List;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;
import org.dfra.persona.Attributes;
import org.dfra.persona.RangeAttributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/** The attributes by which clients find the laser. Updated by the reader, read by any thread. */
final class LmsPersona {

  /** Power in watts, without heating; technical description of the LMS 200. */
  private static final double POWER = 20;

  private static final SensorAttributes SENSOR =
      new SensorAttributes(
          "RangeScan",
          List.of("continuous", "polled"),
          1.0 / 60,
          LmsVariant.REVOLUTIONS_PER_SECOND,
          POWER,
          List.of("Its front window is clean.", "No sun and no other laser shines into it."));

  private final LmsSettings settings;
  private volatile LmsAttributes laser = LmsAttributes.UNKNOWN;
  private volatile @Nullable RangeAttributes sight;

  LmsPersona(LmsSettings orders) {
    this.settings = orders;
  }

  /** All attributes; the range attributes are the configured ones until the first scan. */
  List<Attributes> all() {
    @Nullable RangeAttributes seen = sight;
    RangeAttributes range =
        seen != null
            ? seen
            : sight(
                settings.measuringMode().orElse(MeasuringMode.DEFAULT),
                settings.unit().orElse(LmsUnit.CM),
                settings.variant());
    return List.of(SENSOR, range, laser);
  }

  /** Bits per second of the link, as reported, or as configured. */
  int baud() {
    Integer reported = laser.baud();
    return reported == null ? settings.baud().orElse(LmsBaud.B9600).rate() : reported;
  }

  /** Processes a telegram from the laser. */
  void update(LmsMessage.Telegram telegram) {
    if (telegram instanceof LmsStatus status) {
      laser = laser.with(status);
    } else if (telegram instanceof LmsMessage.TypeReply type) {
      laser = laser.withType(type.type());
    }
  }

  /** Updates the range attributes from a scan. */
  void updateRangeAttributes(MeasuringMode mode, LmsUnit unit, LmsVariant variant) {
    RangeAttributes now = sight(mode, unit, variant);
    if (!now.equals(sight)) {
      sight = now;
    }
  }

  private static RangeAttributes sight(MeasuringMode mode, LmsUnit unit, LmsVariant variant) {
    return new RangeAttributes(
        0, mode.maxRange(unit), variant.fieldOfView(), variant.step(), unit.accuracy());
  }
}
