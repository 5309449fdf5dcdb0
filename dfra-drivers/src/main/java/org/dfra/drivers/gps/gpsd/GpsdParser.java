package org.dfra.drivers.gps.gpsd;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/** Parses the bytes of gpsd's protocol into messages. */
public final class GpsdParser extends FrameParser<GpsdMessage> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public GpsdParser(Consumer<? super GpsdMessage> messages) {
    super(new GpsdFramer(), GpsdDecoder::decode, GpsdMessage.Malformed.class::isInstance, messages);
  }

  /** Decodes a whole recording. */
  public static List<GpsdMessage> parse(byte[] bytes) {
    return parse(bytes, GpsdParser::new);
  }
}
