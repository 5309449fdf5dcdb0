package org.dfra.drivers.gyro.kvh;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/** Parses bytes into messages: combines {@link Dsp3000Framer} and {@link Dsp3000Decoder}. */
public final class Dsp3000Parser extends FrameParser<Dsp3000Message> {

  /** Passes every message in the stream to {@code messages}. */
  public Dsp3000Parser(Consumer<? super Dsp3000Message> messages) {
    super(
        new Dsp3000Framer(),
        Dsp3000Decoder::decode,
        message -> message instanceof Dsp3000Message.Malformed,
        messages);
  }

  /** Decodes a whole recording. */
  public static List<Dsp3000Message> parse(byte[] bytes) {
    return parse(bytes, Dsp3000Parser::new);
  }
}
