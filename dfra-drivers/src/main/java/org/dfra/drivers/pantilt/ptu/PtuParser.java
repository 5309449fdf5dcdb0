package org.dfra.drivers.pantilt.ptu;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/** Bytes in, replies out: {@link PtuFramer} and {@link PtuDecoder} in one. */
public final class PtuParser extends FrameParser<PtuReply> {

  /** Gives {@code replies} every reply in the stream. */
  public PtuParser(Consumer<? super PtuReply> replies) {
    // Any text is one: whether it answers the question, only who asked can tell.
    super(new PtuFramer(), PtuDecoder::decode, reply -> false, replies);
  }

  /** Decodes a whole recording. */
  public static List<PtuReply> parse(byte[] bytes) {
    return parse(bytes, PtuParser::new);
  }
}
