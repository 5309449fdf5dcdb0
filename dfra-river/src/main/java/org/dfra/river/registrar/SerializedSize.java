package org.dfra.river.registrar;

import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import org.jspecify.annotations.Nullable;

/** The size of objects in reggie's log, which is about their size in memory. */
final class SerializedSize {

  private SerializedSize() {}

  /**
   * The total size of objects; shared parts count once.
   *
   * @param objects from a call, so that their size is already limited
   * @return bytes
   * @throws IllegalArgumentException if one cannot be serialized, as reggie would have to
   */
  static long of(@Nullable Object... objects) {
    CountingStream counter = new CountingStream();
    try (ObjectOutputStream out = new ObjectOutputStream(counter)) {
      for (@Nullable Object each : objects) {
        out.writeObject(each);
      }
    } catch (IOException e) {
      throw new IllegalArgumentException("what was sent cannot be kept: " + e, e);
    }
    return counter.bytes;
  }

  private static final class CountingStream extends OutputStream {

    private long bytes;

    @Override
    public void write(int b) {
      bytes++;
    }

    @Override
    public void write(byte[] b, int offset, int length) {
      bytes += length;
    }
  }
}
