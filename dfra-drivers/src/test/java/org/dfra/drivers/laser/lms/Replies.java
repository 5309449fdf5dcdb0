package org.dfra.drivers.laser.lms;

import org.dfra.drivers.laser.lms.LmsParser.LmsFramer;

/** The laser's telegrams with chosen content. */
final class Replies {

  private Replies() {}

  /** A reply with these data and the status of a sound laser. */
  static byte[] telegram(int command, int... data) {
    int[] payload = new int[data.length + 2];
    payload[0] = command;
    System.arraycopy(data, 0, payload, 1, data.length);
    payload[payload.length - 1] = 0x10;
    return LmsCommands.telegram(LmsFramer.REPLY, payload);
  }

  /** The same with the ACK before it. */
  static byte[] acknowledged(byte[] telegram) {
    byte[] all = new byte[telegram.length + 1];
    all[0] = LmsFramer.ACK;
    System.arraycopy(telegram, 0, all, 1, telegram.length);
    return all;
  }

  /** A scan in these units, with bytes after the samples. */
  static byte[] scan(int unit, int[] samples, int... counters) {
    int[] data = new int[2 + 2 * samples.length + counters.length];
    data[0] = samples.length & 0xFF;
    data[1] = samples.length >> 8 | unit << 6;
    for (int i = 0; i < samples.length; i++) {
      data[2 + 2 * i] = samples[i] & 0xFF;
      data[3 + 2 * i] = samples[i] >> 8;
    }
    System.arraycopy(counters, 0, data, data.length - counters.length, counters.length);
    return telegram(0xB0, data);
  }
}
