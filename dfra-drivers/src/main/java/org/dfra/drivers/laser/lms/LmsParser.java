package org.dfra.drivers.laser.lms;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/**
 * Parses the laser's bytes into messages. A NAK counts as malformed too: it is a single byte that
 * is frequent in noise, so it does not show that there is a laser.
 */
public final class LmsParser extends FrameParser<LmsMessage> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
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
