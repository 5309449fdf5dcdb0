package org.dfra.drivers.laser.lms;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/**
 * Bytes of the laser in, messages out. A NAK counts as malformed, too: noise has many of its one
 * byte, and none of them shows that there is a laser.
 */
public final class LmsParser extends FrameParser<LmsMessage> {

  /**
   * @param messages is given every message, in order, during {@link #feed} and {@link #finish}
   */
  public LmsParser(Consumer<? super LmsMessage> messages) {
    super(new LmsFramer(), LmsDecoder::decode, LmsParser::isMalformed, messages);
  }

  private static boolean isMalformed(LmsMessage message) {
    return message instanceof LmsMessage.Malformed || message instanceof LmsMessage.Nak;
  }

  /** Decodes a whole recording. */
  public static List<LmsMessage> parse(byte[] bytes) {
    return parse(bytes, LmsParser::new);
  }
}
