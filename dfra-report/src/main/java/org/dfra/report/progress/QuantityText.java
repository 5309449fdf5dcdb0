package org.dfra.report.progress;

import java.time.Duration;
import java.util.Locale;
import org.dfra.geometry.GeoPosition;

/** Quantities as text output. */
public final class QuantityText {

  private QuantityText() {}

  /** In seconds, or in milliseconds if below 0.1 s. */
  public static String seconds(Duration duration) {
    double seconds = duration.toNanos() / 1e9;
    return seconds < 0.1
        ? String.format(Locale.ROOT, "%.1f ms", seconds * 1000)
        : String.format(Locale.ROOT, "%.2f s", seconds);
  }

  /** A count with its noun, such as {@code 1 reading} or {@code 2 readings}. */
  public static String count(long number, String thing) {
    return number + " " + thing + (number == 1 ? "" : "s");
  }

  /** Latitude and longitude in degrees, to about 0.1 m. */
  public static String place(GeoPosition at) {
    return String.format(
        Locale.ROOT,
        "%.6f° %s, %.6f° %s",
        Math.abs(at.latitude()),
        at.latitude() < 0 ? "S" : "N",
        Math.abs(at.longitude()),
        at.longitude() < 0 ? "W" : "E");
  }
}
