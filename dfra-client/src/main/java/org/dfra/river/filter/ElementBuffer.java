package org.dfra.river.filter;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.StreamCorruptedException;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Stores the bytes that are read from a stream. Its memory grows with the received bytes, not with
 * the lengths that they declare.
 */
final class ElementBuffer {

  private static final int SMALL = 64;
  private static final int CHUNK = 1 << 16;

  private final InputStream in;
  private byte[] bytes = new byte[SMALL];
  private int size;

  ElementBuffer(InputStream in) {
    this.in = in;
  }

  /** Discards all stored bytes. */
  void clear() {
    size = 0;
    if (bytes.length > CHUNK) {
      bytes = new byte[SMALL];
    }
  }

  /** The number of stored bytes. */
  int size() {
    return size;
  }

  /** The byte at an index below {@link #size}, 0 to 255. */
  int at(int index) {
    return bytes[index] & 0xFF;
  }

  /** Copies stored bytes. */
  void copy(int from, byte[] into, int at, int length) {
    System.arraycopy(bytes, from, into, at, length);
  }

  /** The last bytes read, valid until the next read. */
  InputStream last(int count) {
    return new ByteArrayInputStream(bytes, size - count, count);
  }

  /** Whether the stream continues; if so, stores one more byte. */
  boolean readIfAvailable() throws IOException {
    int value = in.read();
    if (value < 0) {
      return false;
    }
    reserve(1);
    bytes[size++] = (byte) value;
    return true;
  }

  /**
   * Reads and stores bytes.
   *
   * @throws EOFException if the stream ends before
   */
  void read(long count) throws IOException {
    long left = count;
    while (left > 0) {
      int chunk = (int) Math.min(left, CHUNK);
      reserve(chunk);
      int read = in.read(bytes, size, chunk);
      if (read < 0) {
        throw new EOFException("the stream ends " + left + " bytes too early");
      }
      size += read;
      left -= read;
    }
  }

  private void reserve(int more) {
    if (size > bytes.length - more) {
      bytes = Arrays.copyOf(bytes, Math.max(size + more, 2 * bytes.length));
    }
  }

  int unsignedByte() throws IOException {
    read(1);
    return at(size - 1);
  }

  int unsignedShort() throws IOException {
    read(Short.BYTES);
    return (at(size - 2) << Byte.SIZE) | at(size - 1);
  }

  int integer() throws IOException {
    read(Integer.BYTES);
    return ByteBuffer.wrap(bytes).getInt(size - Integer.BYTES);
  }

  long longInteger() throws IOException {
    read(Long.BYTES);
    return ByteBuffer.wrap(bytes).getLong(size - Long.BYTES);
  }

  /**
   * Checks a length that a stream declares.
   *
   * @throws StreamCorruptedException if the length is impossible
   */
  static int length(long announced) throws StreamCorruptedException {
    if (announced < 0 || announced > Integer.MAX_VALUE) {
      throw new StreamCorruptedException("a length of " + announced);
    }
    return (int) announced;
  }

  /** Reads a string in modified UTF-8, preceded by its length in two bytes. */
  String name() throws IOException {
    int from = size;
    read(unsignedShort());
    return DataInputStream.readUTF(
        new DataInputStream(new ByteArrayInputStream(bytes, from, size - from)));
  }
}
