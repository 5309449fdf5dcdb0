package org.dfra.drivers.gps.ubx;

import java.time.Duration;
import org.dfra.drivers.gps.ubx.UbxParser.UbxFramer;

/** Commands to the receiver, as the bytes to be sent. Source: u-blox receiver descriptions. */
public final class UbxCommands {

  /** Class and ID of {@code CFG-MSG}, as its acknowledgement names it. */
  static final int CFG_MSG = 0x0601;

  /** Class and ID of {@code CFG-RATE}, as its acknowledgement names it. */
  static final int CFG_RATE = 0x0608;

  private UbxCommands() {}

  /** {@code MON-VER}: requests the receiver's identification. */
  public static byte[] version() {
    return encode(UbxFramer.MON_VER);
  }

  /** {@code CFG-MSG}: requests {@code NAV-PVT} with every solution. */
  public static byte[] positions() {
    return encode(CFG_MSG, UbxFramer.NAV_PVT >> 8, UbxFramer.NAV_PVT, 1);
  }

  /**
   * {@code CFG-MSG}: requests {@code NAV-SAT} with every n-th solution.
   *
   * @param every number of solutions per message, 1 to 255
   */
  public static byte[] satellites(int every) {
    return encode(CFG_MSG, UbxFramer.NAV_SAT >> 8, UbxFramer.NAV_SAT, every);
  }

  /** {@code CFG-RATE}: sets the period of solutions, aligned to multiples of it in UTC. */
  public static byte[] period(Duration period) {
    int millis = (int) period.toMillis();
    return encode(CFG_RATE, millis, millis >> 8, 1, 0, 0, 0);
  }

  /**
   * Encodes a frame.
   *
   * @param type class and ID, the class in the high byte
   * @param payload its bytes; only the low eight bits of each are used
   */
  public static byte[] encode(int type, int... payload) {
    byte[] frame = new byte[payload.length + UbxFramer.AROUND];
    frame[0] = (byte) 0xB5;
    frame[1] = 0x62;
    frame[2] = (byte) (type >> 8);
    frame[3] = (byte) type;
    frame[4] = (byte) payload.length;
    frame[5] = (byte) (payload.length >> 8);
    for (int i = 0; i < payload.length; i++) {
      frame[UbxFramer.HEAD + i] = (byte) payload[i];
    }
    int sum = UbxFramer.checksum(frame, 2, frame.length - 2);
    frame[frame.length - 2] = (byte) sum;
    frame[frame.length - 1] = (byte) (sum >> 8);
    return frame;
  }
}
