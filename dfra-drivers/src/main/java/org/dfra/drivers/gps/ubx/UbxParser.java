package org.dfra.drivers.gps.ubx;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;

/** Parses the bytes of UBX into messages. */
public final class UbxParser extends FrameParser<UbxMessage> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public UbxParser(Consumer<? super UbxMessage> messages) {
    super(new UbxFramer(), UbxDecoder::decode, UbxMessage.Malformed.class::isInstance, messages);
  }

  /** Decodes a whole recording. */
  public static List<UbxMessage> parse(byte[] bytes) {
    return parse(bytes, UbxParser::new);
  }
}
