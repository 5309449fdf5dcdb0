package org.dfra.drivers.camera.mjpeg;

/** Received bytes that are not parsed yet, in one array that grows up to a bound. */
final class ByteQueue {

  private static final int FIRST = 16 * 1024;

  private final int most;
  private byte[] bytes;
  private int start;
  private int end;

  /**
   * @param maxBytes maximum number of bytes held
   */
  ByteQueue(int maxBytes) {
    this.most = maxBytes;
    this.bytes = new byte[Math.min(FIRST, maxBytes)];
  }

  /** Adds as many bytes as fit; returns how many. */
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

  /**
   * The array that holds the bytes, from {@link #start} to {@link #end}; valid until the next
   * change.
   */
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

  /** Size of the array, bytes. */
  int capacity() {
    return bytes.length;
  }

  /** Removes the first bytes. */
  void skip(int count) {
    start += count;
    if (start == end) {
      start = 0;
      end = 0;
    }
  }

  /** Index of the first occurrence at or after {@code from}; −1 where there is none. */
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

  /** Index after the next line feed at or after {@code from}; −1 where there is none. */
  int endOfLine(int from) {
    for (int i = from; i < end; i++) {
      if (bytes[i] == '\n') {
        return i + 1;
      }
    }
    return -1;
  }

  /** Index after the blank line that ends the head at {@link #start}; −1 if there is none yet. */
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
