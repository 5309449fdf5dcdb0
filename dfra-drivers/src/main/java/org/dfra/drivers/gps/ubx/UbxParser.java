package org.dfra.drivers.gps.ubx;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.StreamCounts;

/** Bytes in, messages out: framer and decoder in one. Confined to one thread. Never throws. */
public final class UbxParser {

  private final UbxFramer framer = new UbxFramer();
  private final Consumer<? super UbxMessage> messages;
  private long malformed;

  /**
   * @param messages is given every message, in order, during {@link #feed} and {@link #finish}
   */
  public UbxParser(Consumer<? super UbxMessage> messages) {
    this.messages = messages;
  }

  /** Decodes a whole recording. */
  public static List<UbxMessage> parse(byte[] bytes) {
    List<UbxMessage> found = new ArrayList<>();
    UbxParser parser = new UbxParser(found::add);
    parser.feed(bytes, 0, bytes.length);
    parser.finish();
    return found;
  }

  /** Takes the next bytes; see {@link UbxFramer#feed}. */
  public void feed(byte[] bytes, int offset, int length) {
    framer.feed(bytes, offset, length, this::decode);
  }

  /** No more bytes will follow; see {@link UbxFramer#finish}. */
  public void finish() {
    framer.finish(this::decode);
  }

  /** What has come so far. */
  public StreamCounts counts() {
    return new StreamCounts(framer.frames(), framer.droppedBytes(), malformed);
  }

  private void decode(byte[] bytes, int offset, int length) {
    UbxMessage message = UbxDecoder.decode(bytes, offset, length);
    if (message instanceof UbxMessage.Malformed) {
      malformed++;
    }
    messages.accept(message);
  }
}
