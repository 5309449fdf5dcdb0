package org.dfra.river.filter;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InvalidObjectException;

/**
 * Throws an exception beyond a number of bytes. The object stream's filter is not called while a
 * long string arrives; this stream still counts.
 */
final class BoundedStream extends FilterInputStream {

  private final long allowed;
  private long seen;

  BoundedStream(InputStream in, long allowed) {
    super(in);
    this.allowed = allowed;
  }

  @Override
  public int read() throws IOException {
    int value = super.read();
    count(value < 0 ? 0 : 1);
    return value;
  }

  @Override
  public int read(byte[] bytes, int from, int length) throws IOException {
    int count = super.read(bytes, from, length);
    count(Math.max(0, count));
    return count;
  }

  @Override
  public long skip(long wanted) throws IOException {
    long skipped = super.skip(wanted);
    count(skipped);
    return skipped;
  }

  private void count(long more) throws IOException {
    seen += more;
    try {
      SerialLimits.atMost(seen, allowed, "bytes", "dfra.serial.bytes");
    } catch (RefusedDataException e) {
      InvalidObjectException refusal = new InvalidObjectException(e.getMessage());
      refusal.initCause(e);
      throw refusal;
    }
  }
}
