package org.dfra.sim.device.drive;

import java.nio.ByteBuffer;

/** Encodes the frames of an rFLEX controller. Its numbers may contain 1B unescaped. */
final class RflexFrames {

  private static final int AROUND = 9;

  private RflexFrames() {}

  /** Port 2, opcode 33: position and velocity of an axis. */
  static byte[] report(int timestamp, int axis, int position, int velocity, int acceleration) {
    ByteBuffer data = ByteBuffer.allocate(25);
    data.putInt(0).putInt(timestamp).put((byte) axis).putInt(position).putInt(velocity);
    return frame(2, 33, data.putInt(acceleration).putInt(30_000).array());
  }

  /** Port 1, opcode 1: hundredths of a volt, and the brake. */
  static byte[] status(int timestamp, int hundredths, boolean brake) {
    ByteBuffer data = ByteBuffer.allocate(9).putInt(timestamp).putInt(hundredths);
    return frame(1, 1, data.put((byte) (brake ? 1 : 0)).array());
  }

  private static byte[] frame(int port, int opcode, byte[] data) {
    ByteBuffer frame = ByteBuffer.allocate(data.length + AROUND);
    frame.put((byte) 0x1B).put((byte) 0x02);
    frame.put((byte) port).put((byte) 0).put((byte) opcode).put((byte) data.length).put(data);
    byte sum = 0;
    for (int i = 2; i < frame.position(); i++) {
      sum ^= frame.get(i);
    }
    return frame.put(sum).put((byte) 0x1B).put((byte) 0x03).array();
  }
}
