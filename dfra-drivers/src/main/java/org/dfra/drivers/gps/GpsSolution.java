package org.dfra.drivers.gps;

import java.time.Instant;
import org.dfra.flow.sensor.GpsFix;
import org.jspecify.annotations.Nullable;

/**
 * What a receiver told of one moment.
 *
 * @param fix the fix, with a position or without
 * @param utcUnconfirmedReason why the fix' time is not UTC for sure, a clause ({@code it does not
 *     tell the date}); null when it is
 * @param state what the receiver does, as the rest of "the receiver is …"
 * @param horizontalAccuracy what the receiver takes its horizontal error for, metres, one sigma;
 *     NaN where it does not tell
 * @param verticalAccuracy the same of its height
 * @param reportsDate whether the fix' date is the receiver's, sure or not; false where the
 *     computer's clock stands in for it
 */
public record GpsSolution(
    GpsFix fix,
    @Nullable String utcUnconfirmedReason,
    String state,
    double horizontalAccuracy,
    double verticalAccuracy,
    boolean reportsDate) {

  /** The same at another time, UTC. */
  GpsSolution withTime(Instant utc) {
    return new GpsSolution(
        new GpsFix(
            fix.mode(),
            fix.position(),
            utc,
            fix.speed(),
            fix.course(),
            fix.dilutionOfPrecision(),
            fix.satellitesVisible(),
            fix.satellitesTracked()),
        utcUnconfirmedReason,
        state,
        horizontalAccuracy,
        verticalAccuracy,
        reportsDate);
  }

  /** Of a receiver that reports the date only together with UTC. */
  public GpsSolution(
      GpsFix fix,
      @Nullable String utcDoubt,
      String state,
      double horizontalAccuracy,
      double verticalAccuracy) {
    this(fix, utcDoubt, state, horizontalAccuracy, verticalAccuracy, utcDoubt == null);
  }

  /** Of a receiver that does not tell how accurate it is. */
  public GpsSolution(GpsFix fix, @Nullable String utcDoubt, String state) {
    this(fix, utcDoubt, state, Double.NaN, Double.NaN);
  }
}
