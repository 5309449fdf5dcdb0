package org.dfra.drivers.gps.m12;

import java.time.Instant;
import java.util.List;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Position;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Time;
import org.dfra.drivers.gps.m12.M12PositionMessage.SatelliteChannel;
import org.dfra.drivers.gps.m12.M12PositionMessage.UtcState;
import org.dfra.flow.sensor.GpsFix;

/**
 * {@code @@Ha}: position, status and data of a twelve-channel receiver. Source: Motorola Oncore
 * M12+ user's guide.
 *
 * @param time date and time of the solution; see {@code utcState} for its scale
 * @param position the position, filtered where the receiver is set to filter
 * @param unfiltered the position of this solution alone
 * @param speed3d speed in space, metres per second
 * @param groundSpeed speed over ground (2-D), metres per second
 * @param heading direction of travel, degrees, 0 to 360, 0 is true north, clockwise is +
 * @param dilution PDOP for a 3-D fix, HDOP for a 2-D one, 0 in position hold
 * @param visible satellites above the horizon by the almanac; may exceed 12
 * @param tracked satellites locked on, 0 to 12
 * @param channels the twelve channels
 * @param status the receiver's state
 * @param clockBias error of the receiver's clock, nanoseconds
 * @param oscillatorOffset the oscillator's frequency, hertz above the nominal one
 * @param temperature of the oscillator, degrees Celsius
 * @param utcState the receiver's knowledge of UTC
 * @param localOffset offset of local time from UTC in minutes, + is east; reported, not applied
 * @param idTag the six letters stored in the receiver for its owner
 */
public record Position12Channels(
    M12Time time,
    M12Position position,
    M12Position unfiltered,
    double speed3d,
    double groundSpeed,
    double heading,
    double dilution,
    int visible,
    int tracked,
    List<SatelliteChannel> channels,
    ReceiverStatus status,
    int clockBias,
    long oscillatorOffset,
    double temperature,
    UtcState utcState,
    int localOffset,
    String idTag)
    implements M12PositionMessage {

  public Position12Channels {
    channels = List.copyOf(channels);
  }

  @Override
  public String id() {
    return "Ha";
  }

  @Override
  public GpsFix.Mode mode() {
    return status.mode();
  }

  @Override
  public String stateInWords() {
    return status.inWords(tracked, visible);
  }

  /**
   * {@inheritDoc} Where the receiver reports GPS time and knows the offset, the time is converted.
   */
  @Override
  public Instant utc() {
    Instant reported = time.toInstant();
    return utcState.isUtc() || !utcState.isKnown()
        ? reported
        : reported.minusSeconds(utcState.offset());
  }

  @Override
  public boolean knowsUtc() {
    return utcState.isKnown();
  }
}
