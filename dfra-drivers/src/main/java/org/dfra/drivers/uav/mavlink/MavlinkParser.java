package org.dfra.drivers.uav.mavlink;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/** Bytes of MAVLink in, frames out. */
public final class MavlinkParser extends FrameParser<MavlinkFrame> {

  private final MavlinkFramer framer;

  /**
   * @param frames is given every frame, in order, during {@link #feed} and {@link #finish}
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

  /** See {@link MavlinkFramer#checksumErrors}; any thread may ask. */
  public long checksumErrors() {
    return framer.checksumErrors();
  }
}
