package org.dfra.drivers.gps.m12;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dfra.drivers.gps.m12.M12Fields.MalformedException;
import org.dfra.drivers.gps.m12.M12Message.HeldPosition;
import org.dfra.drivers.gps.m12.M12Message.M12UtcOffset;
import org.dfra.drivers.gps.m12.M12Message.MalformedMessage;
import org.dfra.drivers.gps.m12.M12Message.OtherMessage;
import org.dfra.drivers.gps.m12.M12Message.PositionControl;
import org.dfra.drivers.gps.m12.M12Message.PositionHoldMode;
import org.dfra.drivers.gps.m12.M12Message.ReceiverClock;
import org.dfra.drivers.gps.m12.M12Message.ReceiverIdentification;
import org.dfra.drivers.gps.m12.M12Message.TimeRaim;
import org.dfra.drivers.gps.m12.M12Message.TimeScale;
import org.dfra.drivers.gps.m12.M12Message.VisibleSatellites;
import org.dfra.drivers.gps.m12.M12PositionMessage.SatelliteChannel;
import org.dfra.drivers.gps.m12.M12PositionMessage.ShortPosition;
import org.dfra.drivers.gps.m12.M12PositionMessage.UtcState;

/**
 * Decodes intact frames, one at a time. Pure; never throws, whatever the content of a frame: an
 * invalid value makes a {@link MalformedMessage}.
 */
final class M12Decoder {

  private static final int HIGHEST_MODE = 8;

  private M12Decoder() {}

  /**
   * Decodes a frame found by {@link M12Parser.M12Framer}.
   *
   * @param bytes holds it
   * @param offset index of its first {@code @}
   * @param length its length in bytes, the right one for its ID
   */
  public static M12Message decode(byte[] bytes, int offset, int length) {
    String id = new String(bytes, offset + 2, 2, StandardCharsets.US_ASCII);
    M12Fields fields = new M12Fields(bytes, offset);
    try {
      return switch (id) {
        case "Ha" -> position12(fields);
        case "Ea" -> position8(fields);
        case "Hb" -> shortPosition(fields);
        case "Bb" -> visible(fields);
        case "Hn" -> timeRaim(fields, id, 4, fields.u32(8), 12);
        case "En" -> timeRaim(fields, id, 19, 0, 23);
        case "Gd" ->
            new PositionControl(
                PositionControl.Mode.values()[fields.within("mode", fields.u8(4), 0, 3)]);
        case "At" ->
            new PositionHoldMode(
                PositionHoldMode.Mode.values()[fields.within("position hold", fields.u8(4), 0, 2)]);
        case "Gb" -> new ReceiverClock(fields.clock(), fields.localOffset(11));
        case "As" -> new HeldPosition(fields.heldPosition());
        case "Bo" -> new M12UtcOffset((byte) fields.u8(4));
        case "Aw" -> new TimeScale(fields.within("time scale", fields.u8(4), 0, 1) == 1);
        case "Cj" -> ReceiverIdentification.of(bytes, offset + 4, offset + length - 3);
        default -> new OtherMessage(id, Arrays.copyOfRange(bytes, offset + 4, offset + length - 3));
      };
    } catch (MalformedException e) {
      return new MalformedMessage(id, String.valueOf(e.getMessage()));
    }
  }

  private static Position12Channels position12(M12Fields fields) throws MalformedException {
    SatelliteChannel[] channels = new SatelliteChannel[12];
    for (int i = 0; i < channels.length; i++) {
      int at = 57 + 6 * i;
      channels[i] =
          new SatelliteChannel(
              fields.u8(at),
              fields.within("mode of channel " + i, fields.u8(at + 1), 0, HIGHEST_MODE),
              fields.u8(at + 2),
              fields.u8(at + 3),
              fields.u16(at + 4));
    }
    return new Position12Channels(
        fields.time(),
        fields.position(15),
        fields.position(31),
        fields.speed(47),
        fields.speed(49),
        fields.heading(51),
        fields.dilution(53),
        fields.u8(55),
        fields.within("satellites tracked", fields.u8(56), 0, channels.length),
        Arrays.asList(channels),
        new ReceiverStatus(fields.u16(129)),
        fields.i16(133),
        fields.u32(135),
        fields.i16(139) / 2.0,
        UtcState.of(fields.u8(141)),
        fields.localOffset(142),
        fields.text(145, 6));
  }

  private static ShortPosition shortPosition(M12Fields fields) throws MalformedException {
    return new ShortPosition(
        fields.time(),
        fields.position(15),
        fields.speed(31),
        fields.speed(33),
        fields.heading(35),
        fields.dilution(37),
        fields.u8(39),
        fields.within("satellites tracked", fields.u8(40), 0, 12),
        new ReceiverStatus(fields.u16(41)),
        fields.text(45, 6));
  }

  private static VisibleSatellites visible(M12Fields fields) throws MalformedException {
    int count = fields.u8(4);
    int reported = Math.min(count, 12);
    List<VisibleSatellites.VisibleSatellite> places = new ArrayList<>(reported);
    for (int i = 0; i < reported; i++) {
      int at = 5 + 7 * i;
      places.add(
          new VisibleSatellites.VisibleSatellite(
              fields.u8(at),
              fields.i16(at + 1),
              fields.within("elevation", fields.u8(at + 3), 0, 90),
              fields.within("azimuth", fields.u16(at + 4), 0, 360),
              fields.u8(at + 6)));
    }
    return new VisibleSatellites(count, places);
  }

  /** The two messages have the same fields, except for the removed satellites. */
  private static TimeRaim timeRaim(
      M12Fields fields, String id, int pulseAt, long removed, int accuracyAt)
      throws MalformedException {
    return new TimeRaim(
        id,
        fields.u8(pulseAt) == 1,
        TimeRaim.Solution.values()[fields.within("solution status", fields.u8(pulseAt + 2), 0, 2)],
        TimeRaim.Ability.values()[fields.within("RAIM status", fields.u8(pulseAt + 3), 0, 2)],
        removed,
        fields.u16(accuracyAt),
        (byte) fields.u8(accuracyAt + 2));
  }

  private static Position8Channels position8(M12Fields fields) throws MalformedException {
    SatelliteChannel[] channels = new SatelliteChannel[8];
    for (int i = 0; i < channels.length; i++) {
      int at = 40 + 4 * i;
      channels[i] =
          new SatelliteChannel(
              fields.u8(at),
              fields.within("mode of channel " + i, fields.u8(at + 1), 0, HIGHEST_MODE),
              fields.u8(at + 2),
              -1,
              fields.u8(at + 3));
    }
    int type = fields.u8(37);
    return new Position8Channels(
        fields.time(),
        fields.position(15),
        fields.speed(31),
        fields.heading(33),
        fields.dilution(35),
        (type & 1) != 0,
        ReceiverStatus.Antenna.of(type >> 6),
        fields.u8(38),
        fields.within("satellites tracked", fields.u8(39), 0, channels.length),
        Arrays.asList(channels),
        fields.u8(72));
  }
}
