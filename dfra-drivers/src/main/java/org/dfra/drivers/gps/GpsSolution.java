package org.dfra.drivers.gps;

import java.time.Instant;
import org.dfra.flow.sensor.GpsFix;
import org.jspecify.annotations.Nullable;

/**
 * A receiver's solution for one epoch.
 *
 * @param fix the fix, with a position or without
 * @param utcUnconfirmedReason why UTC is unconfirmed for the fix's time, a clause ({@code it does
 *     not tell the date}); null when it is confirmed
 * @param state the receiver's state, completing "the receiver is …"
 * @param horizontalAccuracy estimated horizontal accuracy, metres, one sigma; NaN where it is not
 *     reported
 * @param verticalAccuracy the same for the height
 * @param reportsDate whether the fix's date is the receiver's, confirmed or not; false where it is
 *     from the computer's clock
 */
public record GpsSolution(
    GpsFix fix,
    @Nullable String utcUnconfirmedReason,
    String state,
    double horizontalAccuracy,
    double verticalAccuracy,
    boolean reportsDate) {

  /** A copy with another time, UTC. */
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

  /** For a receiver that reports the date only together with UTC. */
  public GpsSolution(
      GpsFix fix,
      @Nullable String utcDoubt,
      String state,
      double horizontalAccuracy,
      double verticalAccuracy) {
    this(fix, utcDoubt, state, horizontalAccuracy, verticalAccuracy, utcDoubt == null);
  }

  /** For a receiver that does not report its accuracy. */
  public GpsSolution(GpsFix fix, @Nullable String utcDoubt, String state) {
    this(fix, utcDoubt, state, Double.NaN, Double.NaN);
  }
}
