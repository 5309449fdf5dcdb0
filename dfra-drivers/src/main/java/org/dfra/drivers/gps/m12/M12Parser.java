package org.dfra.drivers.gps.m12;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/** Parses the bytes of Motorola's binary protocol into messages. */
public final class M12Parser extends FrameParser<M12Message> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public M12Parser(Consumer<? super M12Message> messages) {
    super(new M12Framer(), M12Decoder::decode, MalformedMessage.class::isInstance, messages);
  }

  /** Decodes a whole recording. */
  public static List<M12Message> parse(byte[] bytes) {
    return parse(bytes, M12Parser::new);
  }
}
