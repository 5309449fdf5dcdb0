package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.time.Instant;

/**
 * A device between its two wires: takes bytes, sends bytes. Knows no thread and reads no clock;
 * confined to one thread, which says what time it is.
 */
public interface SerialDevice {

  /**
   * Takes bytes from the computer, cut anywhere.
   *
   * @param bytes holds them
   * @param offset index of the first
   * @param length how many
   * @param time when they came
   */
  void receive(byte[] bytes, int offset, int length, Instant time);

  /**
   * Puts the bytes that have come out of the device by {@code time}, and not been put before, into
   * {@code out}, as far as they fit.
   */
  void transmit(ByteBuffer out, Instant time);

  /**
   * Bits per second of its line now, by which what comes from the computer is paced; what it sends
   * it paces itself. 0 where it is on no serial line, and everything comes at once.
   */
  default int baud() {
    return 0;
  }

  /**
   * Whether bytes that the computer does not take at once are kept for it, as on a network. On a
   * serial line they are lost.
   */
  default boolean buffersOutput() {
    return false;
  }

  /** A new computer is on the line; devices that are not on a serial line begin anew for it. */
  default void connected() {}

  /** The computer has left the line; devices that are not on a serial line notice. */
  default void disconnected() {}
}
