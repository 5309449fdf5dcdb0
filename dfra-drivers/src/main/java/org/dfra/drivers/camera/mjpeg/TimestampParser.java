package org.dfra.drivers.camera.mjpeg;

import java.time.Instant;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads {@code X-Timestamp}: seconds since 1970, UTC, with decimals. */
final class TimestampParser {

  private static final Pattern SECONDS = Pattern.compile("([0-9]{1,10})(?:\\.([0-9]{1,9}))?");

  private TimestampParser() {}

  /** Parses the time; empty where the text is invalid. */
  static Optional<Instant> of(String text) {
    Matcher matcher = SECONDS.matcher(text);
    if (!matcher.matches()) {
      return Optional.empty();
    }
    String decimals = matcher.group(2) == null ? "" : matcher.group(2);
    long nanos = Long.parseLong((decimals + "000000000").substring(0, 9));
    return Optional.of(Instant.ofEpochSecond(Long.parseLong(matcher.group(1)), nanos));
  }
}
