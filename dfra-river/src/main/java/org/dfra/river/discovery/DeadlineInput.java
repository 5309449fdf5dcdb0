package org.dfra.river.discovery;

import java.io.IOException;
import java.io.InputStream;
import java.io.InvalidObjectException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.concurrent.TimeUnit;

/**
 * The input from a socket, limited by a deadline and a number of bytes. One deadline applies to all
 * reads together, so a peer that sends single bytes slowly gains no time.
 */
final class DeadlineInput extends InputStream {

  private final Socket socket;
  private final InputStream in;
  private final long end;
  private final int allowed;
  private int seen;

  /**
   * @param end the deadline, by {@link System#nanoTime}
   * @param allowed maximum number of bytes
   */
  DeadlineInput(Socket socket, long end, int allowed) throws IOException {
    this.socket = socket;
    this.in = socket.getInputStream();
    this.end = end;
    this.allowed = allowed;
  }

  /**
   * The time until a deadline as a socket timeout: at least one millisecond.
   *
   * @throws SocketTimeoutException if it has passed
   */
  static int millisUntil(long end) throws SocketTimeoutException {
    long left = end - System.nanoTime();
    if (left <= 0) {
      throw new SocketTimeoutException("its time is over");
    }
    return (int) Math.min(Integer.MAX_VALUE, Math.max(1, TimeUnit.NANOSECONDS.toMillis(left)));
  }

  @Override
  public int read() throws IOException {
    byte[] one = new byte[1];
    return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
  }

  @Override
  public int read(byte[] bytes, int from, int length) throws IOException {
    if (length == 0) {
      return 0;
    }
    socket.setSoTimeout(millisUntil(end));
    int count = in.read(bytes, from, Math.min(length, allowed - seen + 1));
    seen += Math.max(0, count);
    if (seen > allowed) {
      throw new InvalidObjectException("it is longer than the " + allowed + " bytes allowed");
    }
    return count;
  }
}
