package org.dfra.drivers.drive.rflex;

import java.nio.ByteBuffer;
import org.dfra.drivers.drive.rflex.RflexMessage.Axis;

/**
 * What an rFLEX controller can be told, as frames. Pure.
 *
 * <p>No frame has the byte 1B anywhere but in its first and its last but one place. Where a number
 * that was asked for would bring one in, the nearest that does not takes its place: of a velocity
 * that is off by 1 count, or by at most 128 counts, which are 1.5 mm/s, where its second byte is
 * concerned. The checksum may become 1B too; then the least important number, a torque or a period,
 * is moved until it is not.
 */
public final class RflexCommands {

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
   * Have an axis move so from now on.
   *
   * @param velocity counts per second, its sign is the direction; up to 2³² − 1 either way
   * @param acceleration counts per second squared by which it gets there, 0 to 2³² − 1
   * @param torque the most torque, in the controller's unit, 0 to 2³² − 1
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
   * Tell where both axes are, again and again.
   *
   * @param period microseconds, 0 to 2³² − 1; 0 for no more
   */
  public static byte[] reports(long period) {
    ByteBuffer data = ByteBuffer.allocate(8).putInt((int) period).putInt(BOTH_AXES);
    return clean(RflexDecoder.MOTION, REQUEST_REPORTS, data, 0, period);
  }

  /** Tell battery and brake, once. */
  public static byte[] status() {
    return frame(RflexDecoder.SYSTEM, RflexDecoder.STATUS, new byte[0]);
  }

  /** Forget velocities, accelerations and torques that were set. */
  public static byte[] defaults() {
    return frame(RflexDecoder.MOTION, SET_DEFAULTS, new byte[0]);
  }

  /** Set or release the brake. */
  public static byte[] brake(boolean set) {
    return frame(RflexDecoder.MOTION, set ? SET_BRAKE : RELEASE_BRAKE, new byte[0]);
  }

  /** The frame with the number at {@code at}, or the nearest one, that makes it free of 1B. */
  private static byte[] clean(int port, int opcode, ByteBuffer data, int at, long requested) {
    long below = EscapeFreeNumbers.atMost(requested);
    long above = EscapeFreeNumbers.atLeast(requested);
    while (true) { // ends soon: a number next to another has another checksum
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
}
