package org.dfra.drivers.link;

import java.io.IOException;
import java.time.Duration;

/**
 * A byte link to a device.
 *
 * <p>Reading is confined to one thread at a time. Any thread may write, close and query the link.
 * {@code toString} is the link's URL.
 */
public interface SerialLink extends AutoCloseable {

  /**
   * Waits for bytes and returns the available ones.
   *
   * @param buffer where to put them
   * @param offset index of the first byte put
   * @param length maximum number of bytes, at least 1
   * @param timeout maximum wait for the first byte; a link may round it up to its own resolution
   *     (serial ports: 0.1 s)
   * @return number of bytes read; 0 after the timeout; −1 when the device is lost or the link
   *     closed, and always after that
   */
  int read(byte[] buffer, int offset, int length, Duration timeout);

  /**
   * Writes all of {@code bytes} to the link.
   *
   * @throws IOException if the device is lost or the link closed
   */
  void write(byte[] bytes) throws IOException;

  /**
   * Sets the baud rate of this end of the link, for all following bytes. The far end is not
   * notified. Does nothing where this end has no settable rate, such as a serial server on the
   * network or a recording.
   *
   * @param baud bits per second
   * @throws IOException if the rate is not supported, or the link is lost
   */
  default void setBaud(int baud) throws IOException {}

  /** Whether the link is neither closed nor known to be lost. */
  boolean isOpen();

  /**
   * Closes the link and unblocks a waiting reader immediately. Does nothing when already closed.
   */
  @Override
  void close();
}
