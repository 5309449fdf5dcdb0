package org.dfra.drivers.gps.m12;

/** Commands to the receiver, as the bytes to be sent. Source: Motorola Oncore M12+ user's guide. */
public final class M12Commands {

  private M12Commands() {}

  /**
   * {@code @@Ha}: position, status and satellites of twelve channels.
   *
   * @param rate seconds from one message to the next, 1 to 255; 0 for one message now and no more
   */
  public static byte[] positionOf12Channels(int rate) {
    return encode("Ha", checkedRate(rate));
  }

  /**
   * {@code @@Ea}: position, status and satellites of eight channels, as older receivers send it.
   *
   * @param rate as for {@link #positionOf12Channels}
   */
  public static byte[] positionOf8Channels(int rate) {
    return encode("Ea", checkedRate(rate));
  }

  /** {@code @@Cj}: what the receiver is. */
  public static byte[] identification() {
    return encode("Cj");
  }

  /** {@code @@Cf}: be as when it left the factory, sending nothing. Answered by the same. */
  public static byte[] defaults() {
    return encode("Cf");
  }

  /** {@code @@Aw}: tell time as UTC (1), not as GPS time (0). */
  public static byte[] utcTime() {
    return encode("Aw", 1);
  }

  /**
   * A frame.
   *
   * @param id the two letters
   * @param payload its bytes, of which the low eight bits count
   */
  public static byte[] encode(String id, int... payload) {
    byte[] frame = new byte[payload.length + 7];
    frame[0] = '@';
    frame[1] = '@';
    frame[2] = (byte) id.charAt(0);
    frame[3] = (byte) id.charAt(1);
    for (int i = 0; i < payload.length; i++) {
      frame[4 + i] = (byte) payload[i];
    }
    frame[frame.length - 3] = checksum(frame, 2, frame.length - 3);
    frame[frame.length - 2] = '\r';
    frame[frame.length - 1] = '\n';
    return frame;
  }

  /** The exclusive or of the bytes from {@code from} to before {@code to}. */
  static byte checksum(byte[] bytes, int from, int to) {
    byte sum = 0;
    for (int i = from; i < to; i++) {
      sum ^= bytes[i];
    }
    return sum;
  }

  private static int checkedRate(int rate) {
    if (rate < 0 || rate > 255) {
      throw new IllegalArgumentException("rate " + rate + " s is outside 0 to 255 s");
    }
    return rate;
  }
}
