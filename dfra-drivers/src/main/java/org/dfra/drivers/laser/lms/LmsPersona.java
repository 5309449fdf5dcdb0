package org.dfra.drivers.laser.lms;

import java.util.List;
import org.dfra.persona.Attributes;
import org.dfra.persona.RangeAttributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/** What the laser says of itself to those who look for one. Told by the reader, asked by anyone. */
final class LmsPersona {

  /** Watts, without heating; technical description of the LMS 200. */
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

  /** All of it: what it sees is what is wanted until the first scan shows what it is. */
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

  /** Bits per second of the line, as told, or as wanted. */
  int baud() {
    Integer reported = laser.baud();
    return reported == null ? settings.baud().orElse(LmsBaud.B9600).rate() : reported;
  }

  /** Takes what the laser told. */
  void update(LmsMessage.Telegram telegram) {
    if (telegram instanceof LmsStatus status) {
      laser = laser.with(status);
    } else if (telegram instanceof LmsMessage.TypeReply type) {
      laser = laser.withType(type.type());
    }
  }

  /** A scan has shown how it sees. */
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
