package org.dfra.drivers.gps.m12;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.dfra.drivers.gps.m12.M12Fields.MalformedException;

/**
 * Decodes intact frames, one at a time. Pure; never throws on what a frame says: a value that
 * cannot be makes a {@link MalformedMessage}.
 */
public final class M12Decoder {

  private static final int HIGHEST_MODE = 8;

  private M12Decoder() {}

  /**
   * Decodes a frame found by {@link M12Framer}.
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
    int sign = fields.u8(142) == 0 ? 1 : -1;
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
        sign * (60 * fields.u8(143) + fields.u8(144)),
        fields.text(145, 6));
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
