package org.dfra.drivers.pantilt.ptu;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/** Parses bytes into replies: combines {@link PtuFramer} and {@link PtuDecoder}. */
public final class PtuParser extends FrameParser<PtuReply> {

  /** Passes every reply in the stream to {@code replies}. */
  public PtuParser(Consumer<? super PtuReply> replies) {
    // Any text is a reply; only the sender of the query can check it.
    super(new PtuFramer(), PtuDecoder::decode, reply -> false, replies);
  }

  /** Decodes a whole recording. */
  public static List<PtuReply> parse(byte[] bytes) {
    return parse(bytes, PtuParser::new);
  }
}
