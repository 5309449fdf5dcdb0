package org.dfra.drivers.gps.nmea;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/** Parses the bytes of NMEA 0183 into sentences. */
public final class NmeaParser extends FrameParser<NmeaSentence> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public NmeaParser(Consumer<? super NmeaSentence> messages) {
    super(
        new NmeaFramer(),
        new NmeaDecoder()::decode,
        NmeaSentence.Malformed.class::isInstance,
        messages);
  }

  /** Decodes a whole recording. */
  public static List<NmeaSentence> parse(byte[] bytes) {
    return parse(bytes, NmeaParser::new);
  }
}
