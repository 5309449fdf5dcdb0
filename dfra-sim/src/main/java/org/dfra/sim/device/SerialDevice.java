package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.time.Instant;

/**
 * A device at the byte level of its serial interface: receives bytes, sends bytes. It has no thread
 * and reads no clock; its caller, one thread, passes the time.
 */
public interface SerialDevice {

  /**
   * Receives bytes from the computer, split anywhere.
   *
   * @param bytes holds them
   * @param offset index of the first
   * @param length how many
   * @param time time of arrival
   */
  void receive(byte[] bytes, int offset, int length, Instant time);

  /**
   * Puts the bytes that the device has sent by {@code time}, each once, into {@code out}, as far as
   * they fit.
   */
  void transmit(ByteBuffer out, Instant time);

  /**
   * Current bits per second of its serial line, which pace the computer's bytes; the device paces
   * its own output. 0 without a serial line: bytes arrive at once.
   */
  default int baud() {
    return 0;
  }

  /**
   * Whether output that the computer does not read at once is buffered, as on a network. On a
   * serial line it is lost.
   */
  default boolean buffersOutput() {
    return false;
  }

  /** A new computer is connected; devices without a serial line start a new session. */
  default void connected() {}

  /** The computer was disconnected; devices without a serial line detect this. */
  default void disconnected() {}
}
