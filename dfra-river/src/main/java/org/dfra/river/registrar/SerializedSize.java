package org.dfra.river.registrar;

import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import org.jspecify.annotations.Nullable;

/** How large objects are when reggie writes them to its log, which is about what they take here. */
final class SerializedSize {

  private SerializedSize() {}

  /**
   * The size of objects together; what they share counts once.
   *
   * @param objects from a call, so that their size is bounded already
   * @return bytes
   * @throws IllegalArgumentException if one cannot be written, which reggie would have to
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
