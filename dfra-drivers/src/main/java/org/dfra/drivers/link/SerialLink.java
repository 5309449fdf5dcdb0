package org.dfra.drivers.link;

import java.io.IOException;
import java.time.Duration;

/**
 * A byte link to a device.
 *
 * <p>Reading is confined to one thread at a time. Writing, closing and asking may be done from any
 * thread. {@code toString} is the link's URL.
 */
public interface SerialLink extends AutoCloseable {

  /**
   * Waits for bytes and takes what is there.
   *
   * @param buffer where to put them
   * @param offset index of the first byte put
   * @param length most bytes to take, at least 1
   * @param timeout longest wait for the first byte; a link may round it up to its own resolution
   *     (serial ports: 0.1 s)
   * @return how many bytes were taken; 0 when none came in time; −1 when the device is lost or the
   *     link closed, from then on always
   */
  int read(byte[] buffer, int offset, int length, Duration timeout);

  /**
   * Hands all of {@code bytes} to the line.
   *
   * @throws IOException if the device is lost or the link closed
   */
  void write(byte[] bytes) throws IOException;

  /**
   * Sets the speed of this end of the line, for what is read and written from now on. The far end
   * is not told. Does nothing where this end has no speed that it can set: a serial server on the
   * network has its own, a recording has none.
   *
   * @param baud bits per second
   * @throws IOException if the line cannot be that fast, or is lost
   */
  default void setBaud(int baud) throws IOException {}

  /** Whether the link is neither closed nor known to be lost. */
  boolean isOpen();

  /** Closes the link and frees a waiting reader at once. Does nothing when already closed. */
  @Override
  void close();
}
