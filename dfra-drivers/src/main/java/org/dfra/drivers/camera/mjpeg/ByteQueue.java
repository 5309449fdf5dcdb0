package org.dfra.drivers.camera.mjpeg;

/** Bytes that wait to be understood, in one array. It grows up to a bound and never beyond. */
final class ByteQueue {

  private static final int FIRST = 16 * 1024;

  private final int most;
  private byte[] bytes;
  private int start;
  private int end;

  /**
   * @param maxBytes bytes that it holds at the most
   */
  ByteQueue(int maxBytes) {
    this.most = maxBytes;
    this.bytes = new byte[Math.min(FIRST, maxBytes)];
  }

  /** Takes as many as it has room for; how many. */
  int add(byte[] from, int offset, int length) {
    if (bytes.length - end < length) {
      makeRoom(length);
    }
    int part = Math.min(length, bytes.length - end);
    System.arraycopy(from, offset, bytes, end, part);
    end += part;
    return part;
  }

  private void makeRoom(int length) {
    int required = size() + length;
    byte[] next = bytes;
    if (required > bytes.length) {
      next = new byte[(int) Math.min(most, Math.max(required, 2L * bytes.length))];
    }
    int held = size();
    System.arraycopy(bytes, start, next, 0, held);
    bytes = next;
    start = 0;
    end = held;
  }

  /** The array that holds them, from {@link #start} to {@link #end}; until the next change. */
  byte[] array() {
    return bytes;
  }

  int start() {
    return start;
  }

  int end() {
    return end;
  }

  int size() {
    return end - start;
  }

  /** Bytes of memory taken. */
  int capacity() {
    return bytes.length;
  }

  /** Gives the first ones away. */
  void skip(int count) {
    start += count;
    if (start == end) {
      start = 0;
      end = 0;
    }
  }

  /** Index of the first occurrence that begins at {@code from} or after; −1 where there is none. */
  int find(byte[] needle, int from) {
    for (int i = from; i <= end - needle.length; i++) {
      if (bytes[i] == needle[0] && matches(needle, i)) {
        return i;
      }
    }
    return -1;
  }

  private boolean matches(byte[] needle, int at) {
    for (int i = 1; i < needle.length; i++) {
      if (bytes[at + i] != needle[i]) {
        return false;
      }
    }
    return true;
  }

  /** Index after the next line feed at {@code from} or after; −1 where there is none. */
  int endOfLine(int from) {
    for (int i = from; i < end; i++) {
      if (bytes[i] == '\n') {
        return i + 1;
      }
    }
    return -1;
  }

  /** Index after the blank line that ends a head which begins at {@link #start}; −1: not there. */
  int endOfHead() {
    int line = start;
    for (int next = endOfLine(line); next >= 0; next = endOfLine(line)) {
      boolean isBlank = next - line == 1 || (next - line == 2 && bytes[line] == '\r');
      if (isBlank) {
        return next;
      }
      line = next;
    }
    return -1;
  }
}
