package org.dfra.sim.device.uav;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.jspecify.annotations.Nullable;

/**
 * Encodes MAVLink 2 frames with their checksums. One object numbers the frames of one sender.
 * Confined to one thread.
 */
final class MavlinkFrameWriter {

  /** Bytes before a frame's payload. */
  static final int HEAD = 10;

  /** Bytes after it. */
  static final int TAIL = 2;

  static final int MARK = 0xFD;

  private final int system;
  private final int component;
  private int sent;

  MavlinkFrameWriter(int system, int component) {
    this.system = system;
    this.component = component;
  }

  /** A buffer for the longest payload, little-endian. */
  static ByteBuffer payload() {
    return ByteBuffer.allocate(255).order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * A frame.
   *
   * @param message type of the frame
   * @param payload up to its position
   */
  byte[] frame(MavlinkMessageType message, ByteBuffer payload) {
    int length = payload.position();
    while (length > 1 && payload.get(length - 1) == 0) {
      length--;
    }
    byte[] frame = new byte[HEAD + length + TAIL];
    frame[0] = (byte) MARK;
    frame[1] = (byte) length;
    frame[4] = (byte) sent++;
    frame[5] = (byte) system;
    frame[6] = (byte) component;
    frame[7] = (byte) message.id();
    frame[8] = (byte) (message.id() >> 8);
    System.arraycopy(payload.array(), 0, frame, HEAD, length);
    int sum = sum(frame, 1, HEAD + length, message.extra());
    frame[HEAD + length] = (byte) sum;
    frame[HEAD + length + 1] = (byte) (sum >> 8);
    return frame;
  }

  /** The checksum, bit by bit: polynomial 0x8408, initial value all ones. */
  static int sum(byte[] bytes, int from, int to, int extra) {
    int sum = 0xFFFF;
    for (int i = from; i <= to; i++) {
      sum ^= i == to ? extra : bytes[i] & 0xFF;
      for (int bit = 0; bit < 8; bit++) {
        sum = (sum & 1) == 0 ? sum >> 1 : sum >> 1 ^ 0x8408;
      }
    }
    return sum;
  }

  /**
   * The messages that are sent or understood, with the CRC extra byte that represents their
   * definition in the checksum. Source: mavlink.io, common dialect.
   */
  enum MavlinkMessageType {
    HEARTBEAT(0, 50),
    SYS_STATUS(1, 124),
    SYSTEM_TIME(2, 137),
    GPS_RAW_INT(24, 24),
    GLOBAL_POSITION_INT(33, 104),
    VFR_HUD(74, 20),
    COMMAND_INT(75, 158),
    COMMAND_LONG(76, 152),
    COMMAND_ACK(77, 143),
    BATTERY_STATUS(147, 154),
    AUTOPILOT_VERSION(148, 178),
    EXTENDED_SYS_STATE(245, 130),
    STATUSTEXT(253, 83);

    private final int id;
    private final int extra;

    MavlinkMessageType(int id, int extra) {
      this.id = id;
      this.extra = extra;
    }

    int id() {
      return id;
    }

    int extra() {
      return extra;
    }

    /** The message of that number; null if there is none. */
    static @Nullable MavlinkMessageType of(int id) {
      for (MavlinkMessageType each : values()) {
        if (each.id == id) {
          return each;
        }
      }
      return null;
    }
  }
}
