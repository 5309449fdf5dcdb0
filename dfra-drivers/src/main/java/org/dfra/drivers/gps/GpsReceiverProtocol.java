package org.dfra.drivers.gps;

import java.io.IOException;
import java.time.Instant;
import java.util.List;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.link.SerialLink;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.persona.GpsReceiverAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The protocol of one type of receiver: how to parse its bytes, and what to send to it. Everything
 * else is in {@link GpsReceiverImpl}. The reader thread calls all methods; they must not block.
 */
public interface GpsReceiverProtocol {

  /** Receives what the receiver reports; on the reader thread. */
  interface Listener {

    /** A solution, with a position or without. */
    void solutionReceived(GpsSolution solution);

    /** The satellites in view. */
    void satellitesReceived(List<SatelliteInView> satellites);

    /** The receiver's identity; reported again when more is known. */
    void identityReceived(GpsReceiverAttributes receiver);

    /** An intact message of this name has been received; for threads that wait for it. */
    void messageReceived(String name);

    /**
     * An intact message with an invalid value; the first on a link is logged as a warning.
     *
     * @param name the message's name
     * @param reason which value, what it is, and which values are valid
     */
    void malformedReceived(String name, String reason);

    /** A warning for the operator, as a sentence; it is logged. */
    void warn(String sentence);
  }

  /**
   * The link has been opened: resets the protocol's state and sends the initial commands.
   *
   * @throws IOException if the link is lost already
   */
  void opened(SerialLink link) throws IOException;

  /** Parses the received bytes and passes the messages to the listener; always the same parser. */
  FrameParser<?> parser();

  /**
   * Called after every read, with or without bytes: sends what is due.
   *
   * @throws IOException if the link is lost
   */
  default void periodic(SerialLink link) throws IOException {}

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
   * @param reportsDate whether the fix's date is the receiver's, confirmed or not; false where it
   *     is from the computer's clock
   */
  record GpsSolution(
      GpsFix fix,
      @Nullable String utcUnconfirmedReason,
      String state,
      double horizontalAccuracy,
      double verticalAccuracy,
      boolean reportsDate) {

    /** A copy with another time, UTC. */
    GpsSolution withTime(Instant utc) {
      return new GpsSolution(
          fix.withTime(utc),
          utcUnconfirmedReason,
          state,
          horizontalAccuracy,
          verticalAccuracy,
          reportsDate);
    }

    /** For a receiver that reports the date only together with UTC. */
    public GpsSolution(
        GpsFix fix,
        @Nullable String utcFault,
        String state,
        double horizontalAccuracy,
        double verticalAccuracy) {
      this(fix, utcFault, state, horizontalAccuracy, verticalAccuracy, utcFault == null);
    }

    /** For a receiver that does not report its accuracy. */
    public GpsSolution(GpsFix fix, @Nullable String utcFault, String state) {
      this(fix, utcFault, state, Double.NaN, Double.NaN);
    }
  }

  /**
   * A satellite in a receiver's view.
   *
   * @param name system and number in RINEX notation: {@code G14}; G is GPS, R GLONASS, E Galileo, C
   *     BeiDou, J QZSS, I NavIC, S an augmentation satellite
   * @param elevation above the horizon, degrees, −90 to 90; null where it is not reported
   * @param azimuth from true north, clockwise, degrees, 0 to 360; null where it is not reported
   * @param signal carrier to noise density, dB-Hz; null where it is not tracked
   * @param used whether it is used for the position
   */
  record SatelliteInView(
      String name,
      @Nullable Integer elevation,
      @Nullable Integer azimuth,
      @Nullable Integer signal,
      boolean used) {

    /** Whether the receiver tracks it. */
    public boolean isTracked() {
      return signal != null;
    }

    /** {@code G14 41° up, 60° from north, 47 dB-Hz, used}. */
    @Override
    public String toString() {
      return name
          + (elevation == null ? "" : " " + elevation + "° up,")
          + (azimuth == null ? "" : " " + azimuth + "° from north,")
          + (signal == null ? " not tracked" : " " + signal + " dB-Hz")
          + (used ? ", used" : "");
    }
  }
}
