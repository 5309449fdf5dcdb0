package org.dfra.drivers.uav.mavlink;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/** Parses the bytes of MAVLink into frames. */
public final class MavlinkParser extends FrameParser<MavlinkFrame> {

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
}
