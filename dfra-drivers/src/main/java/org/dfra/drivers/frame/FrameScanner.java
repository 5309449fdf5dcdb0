package org.dfra.drivers.frame;

/**
 * Finds frames in a stream of bytes. Bytes outside frames are dropped and counted one by one, so
 * the scanner resynchronizes with the next intact frame after corrupted data. Never throws,
 * whatever the bytes; allocates no memory.
 *
 * <p>Noise may look like the head of a long frame. No frame is lost then, but following frames are
 * delivered only when that length has been received (at most the longest frame of the protocol) or
 * {@link #finish} is called.
 *
 * <p>Confined to one thread.
 */
public abstract class FrameScanner {

  /** Receives the frames found. */
  @FunctionalInterface
  public interface Sink {

    /**
     * Receives one intact frame.
     *
     * @param buffer holds it; valid only during the call
     * @param offset index of its first byte
     * @param length its length in bytes
     */
    void frame(byte[] buffer, int offset, int length);
  }

  /** Result of {@link #frameLengthAt}: the bytes may be the beginning of a frame. */
  protected static final int NEEDS_MORE = -1;

  /** Result of {@link #frameLengthAt}: no frame begins here. */
  protected static final int NONE = 0;

  private final byte[] pending;
  private int end;
  private long frames;
  private long droppedBytes;

  /**
   * @param longest maximum length of a frame, bytes
   */
  protected FrameScanner(int longest) {
    this.pending = new byte[Math.max(4096, 2 * longest)];
  }

  /**
   * Checks whether a frame begins here. Must not return {@link #NEEDS_MORE} when the bytes of the
   * longest frame are available.
   *
   * @param bytes holds the received bytes
   * @param at index of the first byte to check
   * @param end index after the last received byte
   * @return the frame's length in bytes, {@link #NONE} or {@link #NEEDS_MORE}
   */
  protected abstract int frameLengthAt(byte[] bytes, int at, int end);

  /**
   * Processes the next bytes of the stream, split anywhere.
   *
   * @param bytes holds them
   * @param offset index of the first
   * @param length how many
   * @param sink receives every complete frame, in order
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

  /** Ends the stream: processes the remaining bytes. The next byte fed begins a new stream. */
  public void finish(Sink sink) {
    scan(sink, true);
  }

  /** Frames found since construction. */
  public long frames() {
    return frames;
  }

  /**
   * Bytes since construction that belong to no frame. All bytes fed are these, the bytes of frames,
   * and the {@link #pendingBytes}.
   */
  public long droppedBytes() {
    return droppedBytes;
  }

  /** Bytes fed that may be the beginning of a frame. */
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
