package org.dfra.drivers.gps.gpsd;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.StreamCounts;

/** Bytes in, messages out: framer and decoder in one. Confined to one thread. Never throws. */
public final class GpsdParser {

  private final GpsdFramer framer = new GpsdFramer();
  private final Consumer<? super GpsdMessage> messages;
  private long malformed;

  /**
   * @param messages is given every message, in order, during {@link #feed} and {@link #finish}
   */
  public GpsdParser(Consumer<? super GpsdMessage> messages) {
    this.messages = messages;
  }

  /** Decodes a whole recording. */
  public static List<GpsdMessage> parse(byte[] bytes) {
    List<GpsdMessage> found = new ArrayList<>();
    GpsdParser parser = new GpsdParser(found::add);
    parser.feed(bytes, 0, bytes.length);
    parser.finish();
    return found;
  }

  /** Takes the next bytes; see {@link GpsdFramer#feed}. */
  public void feed(byte[] bytes, int offset, int length) {
    framer.feed(bytes, offset, length, this::decode);
  }

  /** No more bytes will follow; see {@link GpsdFramer#finish}. */
  public void finish() {
    framer.finish(this::decode);
  }

  /** What has come so far. */
  public StreamCounts counts() {
    return new StreamCounts(framer.frames(), framer.droppedBytes(), malformed);
  }

  private void decode(byte[] bytes, int offset, int length) {
    GpsdMessage message = GpsdDecoder.decode(bytes, offset, length);
    if (message instanceof GpsdMessage.Malformed) {
      malformed++;
    }
    messages.accept(message);
  }
}
