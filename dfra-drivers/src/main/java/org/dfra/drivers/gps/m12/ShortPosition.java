package org.dfra.drivers.gps.m12;

import java.time.Instant;
import java.util.List;
import org.dfra.flow.sensor.GpsFix;

/**
 * {@code @@Hb}: position and status of a twelve-channel receiver in a third of the bytes of
 * {@code @@Ha}; it contains no satellites, and not whether its time is UTC. Source: Motorola Oncore
 * M12+ user's guide.
 *
 * @param time date and time of the solution
 * @param position the position
 * @param speed3d speed in space, metres per second
 * @param groundSpeed speed over ground (2-D), metres per second
 * @param heading direction of travel, degrees, 0 to 360, 0 is true north, clockwise is +
 * @param dilution PDOP for a 3-D fix, HDOP for a 2-D one, 0 in position hold
 * @param visible satellites above the horizon by the almanac; may exceed 12
 * @param tracked satellites locked on, 0 to 12
 * @param status the receiver's state
 * @param idTag the six letters stored in the receiver for its owner
 */
public record ShortPosition(
    M12Time time,
    M12Position position,
    double speed3d,
    double groundSpeed,
    double heading,
    double dilution,
    int visible,
    int tracked,
    ReceiverStatus status,
    String idTag)
    implements M12PositionMessage {

  @Override
  public String id() {
    return "Hb";
  }

  @Override
  public List<SatelliteChannel> channels() {
    return List.of();
  }

  @Override
  public GpsFix.Mode mode() {
    return status.mode();
  }

  @Override
  public String stateInWords() {
    return status.inWords(tracked, visible);
  }

  @Override
  public Instant utc() {
    return time.toInstant();
  }

  /** {@inheritDoc} Always false for this message alone; {@code @@Bo} and {@code @@Aw} report it. */
  @Override
  public boolean knowsUtc() {
    return false;
  }
}
