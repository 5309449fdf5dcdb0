package org.dfra.drivers.laser.lms;

import org.dfra.persona.Attributes;
import org.jspecify.annotations.Nullable;

/**
 * The attributes that the laser reports.
 *
 * @param type its type and version, such as {@code LMS200;30106;V02.30}; null until reported
 * @param software version of its software; null until reported
 * @param baud bits per second of its link; null while unknown
 * @param measuringMode code of its measuring mode; null while unknown
 * @param windowClean the dirtiest channel of its window, per cent of a clean one; null while
 *     unknown
 */
public record LmsAttributes(
    @Nullable String type,
    @Nullable String software,
    @Nullable Integer baud,
    @Nullable Integer measuringMode,
    @Nullable Integer windowClean)
    implements Attributes {

  static final LmsAttributes UNKNOWN = new LmsAttributes(null, null, null, null, null);

  LmsAttributes withType(String reported) {
    return new LmsAttributes(reported, software, baud, measuringMode, windowClean);
  }

  LmsAttributes with(LmsStatus reported) {
    return new LmsAttributes(
        type,
        reported.software(),
        reported.baud().map(LmsBaud::rate).orElse(null),
        reported.modeCode(),
        reported.pollution().stream().min(Integer::compare).orElse(null));
  }
}
