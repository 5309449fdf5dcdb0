package org.dfra.drivers.gps.m12;

import java.time.Instant;
import java.util.List;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Position;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Time;
import org.dfra.drivers.gps.m12.M12PositionMessage.SatelliteChannel;
import org.dfra.flow.sensor.GpsFix;

/**
 * {@code @@Ea}: position, status and data of an eight-channel receiver. It has one speed and one
 * position. Whether its time is UTC is reported by {@code @@Bo} and {@code @@Aw}, and whether the
 * position is held by {@code @@At}. Source: Motorola Oncore user's guides, eight-channel messages.
 *
 * @param time date and time of the solution
 * @param position the position
 * @param groundSpeed speed, metres per second
 * @param heading direction of travel, degrees, 0 to 360, 0 is true north, clockwise is +
 * @param dilution dilution of precision
 * @param isHorizontalDilution whether that is HDOP; otherwise PDOP
 * @param antenna state of the antenna
 * @param visible satellites above the horizon by the almanac; may exceed 8
 * @param tracked satellites locked on, 0 to 8
 * @param channels the eight channels
 * @param status the raw status byte: 80 propagate, 40 poor geometry, 20 3-D fix, 10 2-D fix, 08
 *     acquiring or position hold, 02 fewer than 3 satellites, 01 bad almanac (hexadecimal)
 */
public record Position8Channels(
    M12Time time,
    M12Position position,
    double groundSpeed,
    double heading,
    double dilution,
    boolean isHorizontalDilution,
    ReceiverStatus.Antenna antenna,
    int visible,
    int tracked,
    List<SatelliteChannel> channels,
    int status)
    implements M12PositionMessage {

  private static final int PROPAGATE = 0x80;
  private static final int POOR_GEOMETRY = 0x40;
  private static final int FIX_3D = 0x20;
  private static final int FIX_2D = 0x10;
  private static final int ACQUIRING_OR_HOLD = 0x08;
  private static final int TOO_FEW = 0x02;

  public Position8Channels {
    channels = List.copyOf(channels);
  }

  @Override
  public String id() {
    return "Ea";
  }

  /**
   * Whether the position is held if {@code @@At} reports position hold: the two states share a bit.
   * A receiver that tracks no satellite and has fewer than 3 in view is acquiring.
   */
  public boolean mayHold() {
    boolean searches = tracked == 0 && (status & TOO_FEW) != 0;
    return (status & (PROPAGATE | POOR_GEOMETRY | FIX_3D | FIX_2D)) == 0
        && (status & ACQUIRING_OR_HOLD) != 0
        && !searches;
  }

  /** {@inheritDoc} A held position counts as none here; see {@link #mayHold}. */
  @Override
  public GpsFix.Mode mode() {
    if ((status & PROPAGATE) != 0) {
      return GpsFix.Mode.NONE;
    }
    if ((status & FIX_3D) != 0) {
      return GpsFix.Mode.FIX_3D;
    }
    return (status & FIX_2D) != 0 ? GpsFix.Mode.FIX_2D : GpsFix.Mode.NONE;
  }

  @Override
  public String stateInWords() {
    String counts = ", " + tracked + " of " + visible + " tracked";
    if ((status & PROPAGATE) != 0) {
      return ReceiverStatus.State.PROPAGATE.inWords() + counts;
    }
    if ((status & (FIX_3D | FIX_2D)) != 0) {
      return "giving a fix" + counts;
    }
    if ((status & POOR_GEOMETRY) != 0) {
      return ReceiverStatus.State.BAD_GEOMETRY.inWords() + counts;
    }
    return "acquiring satellites or holding its position"
        + ((status & TOO_FEW) != 0 ? ", with fewer than 3 satellites" : "")
        + counts;
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
