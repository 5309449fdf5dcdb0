package org.dfra.drivers.drive.rflex;

import java.nio.ByteBuffer;
import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.drivers.drive.rflex.RflexParser.RflexFramer;

/**
 * Encodes commands to an rFLEX controller as frames. Pure.
 *
 * <p>A frame has the byte 1B only as its first and its last but one byte. A number that contains 1B
 * is replaced by the nearest one without it: a velocity changes by 1 count, or by at most 128
 * counts (1.5 mm/s) where its second byte is 1B. If the checksum is 1B, the least important number,
 * a torque or a period, is changed until it is not.
 */
final class RflexCommands {

  private static final int SET_VELOCITY = 7;
  private static final int SET_DEFAULTS = 10;
  private static final int SET_BRAKE = 11;
  private static final int RELEASE_BRAKE = 12;
  private static final int REQUEST_REPORTS = 34;
  private static final int BOTH_AXES = 3;
  private static final int VELOCITY_LENGTH = 14;
  private static final int TORQUE_AT = 9;

  private RflexCommands() {}

  /**
   * Sets the velocity of an axis.
   *
   * @param velocity counts per second, the sign is the direction; magnitude up to 2³² − 1
   * @param acceleration acceleration to that velocity, counts per second squared, 0 to 2³² − 1
   * @param torque maximum torque, in the controller's unit, 0 to 2³² − 1
   */
  public static byte[] velocity(Axis axis, long velocity, long acceleration, long torque) {
    ByteBuffer data = ByteBuffer.allocate(VELOCITY_LENGTH);
    data.put((byte) axis.ordinal());
    data.putInt((int) EscapeFreeNumbers.nearest(Math.abs(velocity)));
    data.putInt((int) EscapeFreeNumbers.nearest(acceleration));
    data.putInt((int) torque);
    data.put((byte) (velocity < 0 ? 0 : 1));
    return clean(RflexDecoder.MOTION, SET_VELOCITY, data, TORQUE_AT, torque);
  }

  /**
   * Requests periodic reports of both axes.
   *
   * @param period microseconds, 0 to 2³² − 1; 0 stops the reports
   */
  public static byte[] reports(long period) {
    ByteBuffer data = ByteBuffer.allocate(8).putInt((int) period).putInt(BOTH_AXES);
    return clean(RflexDecoder.MOTION, REQUEST_REPORTS, data, 0, period);
  }

  /** Requests one report of battery and brake. */
  public static byte[] status() {
    return frame(RflexDecoder.SYSTEM, RflexDecoder.STATUS, new byte[0]);
  }

  /** Resets velocities, accelerations and torques to the defaults. */
  public static byte[] defaults() {
    return frame(RflexDecoder.MOTION, SET_DEFAULTS, new byte[0]);
  }

  /** Sets or releases the brake. */
  public static byte[] brake(boolean set) {
    return frame(RflexDecoder.MOTION, set ? SET_BRAKE : RELEASE_BRAKE, new byte[0]);
  }

  /** The frame with the requested number at {@code at}, or the nearest number that leaves no 1B. */
  private static byte[] clean(int port, int opcode, ByteBuffer data, int at, long requested) {
    long below = EscapeFreeNumbers.atMost(requested);
    long above = EscapeFreeNumbers.atLeast(requested);
    while (true) { // ends soon: adjacent numbers have different checksums
      boolean isBelow =
          above > EscapeFreeNumbers.MOST || (below >= 0 && requested - below <= above - requested);
      byte[] made = frame(port, opcode, data.putInt(at, (int) (isBelow ? below : above)).array());
      if (made[made.length - 3] != RflexFramer.ESCAPE) {
        return made;
      }
      if (isBelow) {
        below = below == 0 ? -1 : EscapeFreeNumbers.atMost(below - 1);
      } else {
        above = above == EscapeFreeNumbers.MOST ? above + 1 : EscapeFreeNumbers.atLeast(above + 1);
      }
    }
  }

  private static byte[] frame(int port, int opcode, byte[] data) {
    byte[] frame = new byte[data.length + RflexFramer.AROUND];
    frame[0] = RflexFramer.ESCAPE;
    frame[1] = RflexFramer.START;
    frame[2] = (byte) port;
    frame[4] = (byte) opcode;
    frame[5] = (byte) data.length;
    System.arraycopy(data, 0, frame, RflexFramer.HEAD, data.length);
    int end = RflexFramer.HEAD + data.length;
    frame[end] = (byte) RflexFramer.checksum(frame, 2, end);
    frame[end + 1] = RflexFramer.ESCAPE;
    frame[end + 2] = RflexFramer.END;
    return frame;
  }

  /**
   * Four-byte numbers without the byte 1B. The controller treats every 1B as the beginning of an
   * end mark, and its protocol has no escape sequence.
   */
  static final class EscapeFreeNumbers {

    static final long MOST = 0xFFFF_FFFFL;

    private EscapeFreeNumbers() {}

    /**
     * The nearest such number; the smaller of two equally near ones.
     *
     * @param value 0 to {@link #MOST}
     */
    static long nearest(long value) {
      long below = atMost(value);
      long above = atLeast(value);
      return value - below <= above - value ? below : above;
    }

    /**
     * The greatest such number that is not greater.
     *
     * @param value 0 to {@link #MOST}
     */
    static long atMost(long value) {
      int shift = escapeIn(value);
      return shift < 0 ? value : (value >>> shift << shift) - 1; // ends in 1A FF.., all free
    }

    /**
     * The smallest such number that is not smaller.
     *
     * @param value 0 to {@link #MOST}
     */
    static long atLeast(long value) {
      int shift = escapeIn(value);
      return shift < 0 ? value : (value >>> shift << shift) + (1L << shift); // ends in 1C 00..
    }

    /** Position of the first byte that is 1B, in bits from the right; negative if there is none. */
    private static int escapeIn(long value) {
      if (value < 0 || value > MOST) {
        throw new IllegalArgumentException(value + " is outside 0 to " + MOST);
      }
      int shift = 24;
      while (shift >= 0 && (value >>> shift & 0xFF) != RflexFramer.ESCAPE) {
        shift -= 8;
      }
      return shift;
    }
  }
}
