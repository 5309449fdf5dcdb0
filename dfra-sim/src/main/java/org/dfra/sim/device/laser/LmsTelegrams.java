package org.dfra.sim.device.laser;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Encodes an LMS 200's telegrams. Pure. */
final class LmsTelegrams {

  static final byte[] NAK = {0x15};

  private static final byte ACK = 0x06;
  private static final String SOFTWARE = "V02.30 ";
  private static final String TYPE = "LMS200;30106;V02.30 ";
  private static final int STATUS_BYTES = 153;
  private static final int CHANNELS = 8;
  private static final int CALIBRATION = 250;

  private LmsTelegrams() {}

  /** The data of a status reply. */
  record Condition(
      int operatingMode,
      int clean,
      int revolutions,
      int measuringMode,
      int degrees,
      int hundredths,
      int baud,
      int unit) {}

  /**
   * The checksum, by a 16-bit shift register: if the bit shifted out is 1, it is XORed with 8005;
   * then with the last two bytes of the message.
   */
  static int check(byte[] bytes, int from, int to) {
    int high = 0;
    int low = 0;
    for (int i = from; i < to; i++) {
      boolean out = (high & 0x80) != 0;
      high = (high << 1 | low >> 7) & 0xFF;
      low = low << 1 & 0xFF;
      if (out) {
        high ^= 0x80;
        low ^= 0x05;
      }
      high ^= i == from ? 0 : bytes[i - 1] & 0xFF;
      low ^= bytes[i] & 0xFF;
    }
    return high << 8 | low;
  }

  /** A single telegram. */
  static byte[] telegram(int command, byte[] data, int status) {
    ByteBuffer out = ByteBuffer.allocate(8 + data.length).order(ByteOrder.LITTLE_ENDIAN);
    out.put((byte) 0x02).put((byte) 0x80).putShort((short) (2 + data.length));
    out.put((byte) command).put(data).put((byte) status);
    return out.putShort((short) check(out.array(), 0, out.position())).array();
  }

  /** A telegram with the ACK of the one it answers. */
  static byte[] reply(int command, byte[] data, int status) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    all.write(ACK);
    all.writeBytes(telegram(command, data, status));
    return all.toByteArray();
  }

  /** Its type. */
  static byte[] type() {
    return TYPE.getBytes(StandardCharsets.US_ASCII);
  }

  /** Data of a scan: sixteen bits each. */
  static byte[] scan(int unit, int[] samples) {
    ByteBuffer out = ByteBuffer.allocate(2 + 2 * samples.length).order(ByteOrder.LITTLE_ENDIAN);
    out.putShort((short) (samples.length | unit << 14));
    for (int sample : samples) {
      out.putShort((short) sample);
    }
    return out.array();
  }

  /** Data of a change of variant. */
  static byte[] variant(boolean isDone, int degrees, int hundredths) {
    return ByteBuffer.allocate(5)
        .order(ByteOrder.LITTLE_ENDIAN)
        .put((byte) (isDone ? 1 : 0))
        .putShort((short) degrees)
        .putShort((short) hundredths)
        .array();
  }

  /** Data of a list of errors. */
  static byte[] errors(List<LmsEmulatorSettings.StoredError> errors) {
    ByteBuffer out = ByteBuffer.allocate(2 * errors.size());
    errors.forEach(error -> out.put((byte) error.type()).put((byte) error.number()));
    return out.array();
  }

  /** Data of a status reply; offsets are from the preceding command byte. */
  static byte[] status(Condition now) {
    ByteBuffer out = ByteBuffer.allocate(STATUS_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    out.put(1, SOFTWARE.getBytes(StandardCharsets.US_ASCII));
    out.put(8, (byte) now.operatingMode());
    for (int i = 0; i < CHANNELS; i++) {
      out.putShort(19 + 2 * i, (short) (CALIBRATION * now.clean() / 100));
      out.putShort(43 + 2 * i, (short) CALIBRATION);
    }
    out.putShort(67, (short) now.revolutions());
    out.putShort(83, (short) 100); // light, per cent
    out.put(102, (byte) now.measuringMode());
    out.putShort(107, (short) now.degrees());
    out.putShort(109, (short) now.hundredths());
    out.putShort(116, (short) (0x8000 | Math.round(1_000_000.0 / now.baud()) - 1));
    out.put(122, (byte) now.unit());
    out.put(124, SOFTWARE.getBytes(StandardCharsets.US_ASCII));
    byte[] data = new byte[STATUS_BYTES - 1];
    out.get(1, data);
    return data;
  }
}
