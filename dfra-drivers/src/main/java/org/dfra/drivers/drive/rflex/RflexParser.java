package org.dfra.drivers.drive.rflex;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/** Parses the bytes of an rFLEX controller into messages. */
public final class RflexParser extends FrameParser<RflexMessage> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public RflexParser(Consumer<? super RflexMessage> messages) {
    super(
        new RflexFramer(),
        RflexDecoder::decode,
        RflexMessage.Malformed.class::isInstance,
        messages);
  }

  /** Decodes a whole recording. */
  public static List<RflexMessage> parse(byte[] bytes) {
    return parse(bytes, RflexParser::new);
  }
}
