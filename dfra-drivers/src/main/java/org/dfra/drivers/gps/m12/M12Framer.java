package org.dfra.drivers.gps.m12;

/**
 * Finds frames in a stream of bytes. Whatever is not part of a frame is dropped and counted, byte
 * by byte, so after damage it is in step again with the next intact frame. Never throws, whatever
 * the bytes; makes no garbage.
 *
 * <p>A false head may look like the beginning of a long frame. Nothing is lost by that, but what
 * follows is told only once the length is there (at most {@value M12Lengths#LONGEST} bytes) or
 * {@link #finish} says that no more will come.
 *
 * <p>Confined to one thread.
 */
public final class M12Framer {

  /** Takes the frames found. */
  @FunctionalInterface
  public interface Sink {

    /**
     * Takes one frame: head, length, checksum and end are right.
     *
     * @param buffer holds it; valid only during the call
     * @param offset index of its first {@code @}
     * @param length its length in bytes
     */
    void frame(byte[] buffer, int offset, int length);
  }

  private static final int HEAD = 4;
  private static final int TAIL = 3;
  private static final int NEEDS_MORE = -1;

  private final byte[] pending = new byte[4096];
  private int end;
  private long frames;
  private long droppedBytes;

  /**
   * Takes the next bytes of the stream, cut anywhere.
   *
   * @param bytes holds them
   * @param offset index of the first
   * @param length how many
   * @param sink is given every frame that is complete by now, in order
   */
  public void feed(byte[] bytes, int offset, int length, Sink sink) {
    int from = offset;
    int left = length;
    while (left > 0) {
      int part = Math.min(left, pending.length - end); // > 0: less than a frame was left over
      System.arraycopy(bytes, from, pending, end, part);
      end += part;
      from += part;
      left -= part;
      scan(sink, false);
    }
  }

  /**
   * No more bytes will follow what was fed: settles what was left over. The next byte fed begins a
   * new stream.
   */
  public void finish(Sink sink) {
    scan(sink, true);
  }

  /** Frames found since construction. */
  public long frames() {
    return frames;
  }

  /**
   * Bytes since construction that belong to no frame. With the bytes of the frames and the {@link
   * #pendingBytes} it adds up to all bytes fed.
   */
  public long droppedBytes() {
    return droppedBytes;
  }

  /** Bytes fed that may yet turn out to be a frame's beginning. */
  public int pendingBytes() {
    return end;
  }

  private void scan(Sink sink, boolean last) {
    int at = 0;
    while (at < end) {
      int length = frameAt(at);
      if (length > 0) {
        frames++;
        sink.frame(pending, at, length);
        at += length;
      } else if (length == NEEDS_MORE && !last) {
        break;
      } else {
        droppedBytes++;
        at++;
      }
    }
    System.arraycopy(pending, at, pending, 0, end - at);
    end -= at;
  }

  /** The length of the frame that begins at {@code at}, 0 for none, or NEEDS_MORE. */
  private int frameAt(int at) {
    int there = end - at;
    if (pending[at] != '@' || (there > 1 && pending[at + 1] != '@')) {
      return 0;
    }
    if (there > 2 && (pending[at + 2] < 'A' || pending[at + 2] > 'Z')) {
      return 0;
    }
    if (there < HEAD) {
      return NEEDS_MORE;
    }
    int length = M12Lengths.of(pending[at + 2], pending[at + 3]);
    if (length > there) {
      return NEEDS_MORE;
    }
    return length > 0 && isIntact(at, length) ? length : 0;
  }

  private boolean isIntact(int at, int length) {
    int checksumAt = at + length - TAIL;
    return pending[checksumAt + 1] == '\r'
        && pending[checksumAt + 2] == '\n'
        && pending[checksumAt] == M12Commands.checksum(pending, at + 2, checksumAt);
  }
}
