package org.dfra.drivers.frame;

/**
 * Finds frames in a stream of bytes. Whatever is not part of a frame is dropped and counted, byte
 * by byte, so after damage it is in step again with the next intact frame. Never throws, whatever
 * the bytes; makes no garbage.
 *
 * <p>A false head may look like the beginning of a long frame. Nothing is lost by that, but what
 * follows is told only once the length is there (at most the longest frame of the protocol) or
 * {@link #finish} says that no more will come.
 *
 * <p>Confined to one thread.
 */
public abstract class FrameScanner {

  /** Takes the frames found. */
  @FunctionalInterface
  public interface Sink {

    /**
     * Takes one frame, which is intact.
     *
     * @param buffer holds it; valid only during the call
     * @param offset index of its first byte
     * @param length its length in bytes
     */
    void frame(byte[] buffer, int offset, int length);
  }

  /** Answer of {@link #frameLengthAt}: what is there may be the beginning of a frame. */
  protected static final int NEEDS_MORE = -1;

  /** Answer of {@link #frameLengthAt}: no frame begins here. */
  protected static final int NONE = 0;

  private final byte[] pending;
  private int end;
  private long frames;
  private long droppedBytes;

  /**
   * @param longest the longest frame there is, in bytes
   */
  protected FrameScanner(int longest) {
    this.pending = new byte[Math.max(4096, 2 * longest)];
  }

  /**
   * Whether a frame begins here. Must not answer {@link #NEEDS_MORE} when the longest frame is
   * there.
   *
   * @param bytes holds what has come
   * @param at index of the first byte to look at
   * @param end index after the last byte that has come
   * @return the frame's length in bytes, {@link #NONE} or {@link #NEEDS_MORE}
   */
  protected abstract int frameLengthAt(byte[] bytes, int at, int end);

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
      int length = frameLengthAt(pending, at, end);
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
}
