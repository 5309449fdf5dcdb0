package org.dfra.drivers.uav.mavlink;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.frame.FrameScanner;

/** Parses the bytes of MAVLink into frames. */
final class MavlinkParser extends FrameParser<MavlinkParser.MavlinkFrame> {

  private final MavlinkFramer framer;

  /**
   * @param frames receives every frame, in order, during {@link #feed} and {@link #finish}
   */
  public MavlinkParser(Consumer<? super MavlinkFrame> frames) {
    this(new MavlinkFramer(), frames);
  }

  private MavlinkParser(MavlinkFramer framer, Consumer<? super MavlinkFrame> frames) {
    super(
        framer,
        MavlinkDecoder::decode,
        frame -> frame.message() instanceof MavlinkMessage.Malformed,
        frames);
    this.framer = framer;
  }

  /** Decodes a whole recording. */
  public static List<MavlinkFrame> parse(byte[] bytes) {
    return parse(bytes, MavlinkParser::new);
  }

  /** See {@link MavlinkFramer#checksumErrors}; from any thread. */
  public long checksumErrors() {
    return framer.checksumErrors();
  }

  /**
   * An intact frame.
   *
   * @param version of MAVLink, 1 or 2
   * @param system ID of the sender, the vehicle, 1 to 255
   * @param component ID of its component, 1 is the autopilot
   * @param sequence counts the sender's frames, 0 to 255 and again from 0
   * @param message its message
   */
  record MavlinkFrame(
      int version, int system, int component, int sequence, MavlinkMessage message) {

    /** How many frames of the same sender are missing between {@code last} and this. */
    int missingSince(int last) {
      return sequence - last - 1 & 0xFF;
    }
  }

  /**
   * Finds the frames of MAVLink 2, and those of MAVLink 1, which some autopilots send until they
   * have received a frame of MAVLink 2.
   *
   * <p>Three kinds of frames are rejected, and their bytes counted as dropped: messages of unknown
   * dialects, because their checksum cannot be checked; frames with an incompatible flag other than
   * "signed", as the protocol defines; and frames with a wrong checksum, which are also counted
   * separately. A signed frame is accepted without checking its signature: there is no key.
   */
  static final class MavlinkFramer extends FrameScanner {

    static final byte MARK_1 = (byte) 0xFE;
    static final byte MARK_2 = (byte) 0xFD;

    /** Bytes before the payload. */
    static final int HEAD_1 = 6;

    static final int HEAD_2 = 10;

    /** Incompatible flag: a signature follows the checksum. */
    static final int SIGNED = 1;

    private static final int CHECKSUM = 2;
    private static final int SIGNATURE = 13;
    private static final int LONGEST = HEAD_2 + 255 + CHECKSUM + SIGNATURE;

    private volatile long checksumErrors; // written by the one thread that feeds

    /** A framer at the beginning of a stream. */
    public MavlinkFramer() {
      super(LONGEST);
    }

    /** Number of frames of known messages with a wrong checksum. */
    public long checksumErrors() {
      return checksumErrors;
    }

    @Override
    protected int frameLengthAt(byte[] bytes, int at, int end) {
      int there = end - at;
      if (bytes[at] == MARK_2) {
        if (there > 2 && (bytes[at + 2] & ~SIGNED) != 0) {
          return NONE;
        }
        if (there < HEAD_2) {
          return NEEDS_MORE;
        }
        int signature = (bytes[at + 2] & SIGNED) == 0 ? 0 : SIGNATURE;
        return frame(bytes, at, there, HEAD_2, signature, message(bytes, at));
      }
      if (bytes[at] != MARK_1) {
        return NONE;
      }
      return there < HEAD_1 ? NEEDS_MORE : frame(bytes, at, there, HEAD_1, 0, bytes[at + 5] & 0xFF);
    }

    /** The number of the message in a frame of MAVLink 2. */
    static int message(byte[] bytes, int at) {
      return (bytes[at + 7] & 0xFF) | (bytes[at + 8] & 0xFF) << 8 | (bytes[at + 9] & 0xFF) << 16;
    }

    private int frame(byte[] bytes, int at, int there, int head, int signature, int message) {
      int extra = MavlinkCatalogue.crcExtra(message);
      if (extra == MavlinkCatalogue.UNKNOWN) {
        return NONE;
      }
      int covered = head + (bytes[at + 1] & 0xFF);
      int length = covered + CHECKSUM + signature;
      if (there < length) {
        return NEEDS_MORE;
      }
      int sum = checksum(bytes, at + 1, at + covered, extra);
      if (bytes[at + covered] == (byte) sum && bytes[at + covered + 1] == (byte) (sum >> 8)) {
        return length;
      }
      checksumErrors++;
      return NONE;
    }

    /**
     * CRC-16/MCRF4XX: polynomial 0x1021 reflected, initial value 0xFFFF, {@code extra} appended.
     */
    static int checksum(byte[] bytes, int from, int to, int extra) {
      int sum = 0xFFFF;
      for (int i = from; i < to; i++) {
        sum = with(sum, bytes[i] & 0xFF);
      }
      return with(sum, extra);
    }

    /** The checksum with one more byte, four bits at a time. */
    private static int with(int sum, int value) {
      int low = (sum ^ value) & 0xFF;
      int mixed = (low ^ low << 4) & 0xFF;
      return sum >> 8 ^ mixed << 8 ^ mixed << 3 ^ mixed >> 4;
    }
  }
}
