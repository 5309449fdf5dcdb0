package org.dfra.drivers.gps.m12;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.StreamCounts;

/** Bytes in, messages out: framer and decoder in one. Confined to one thread. Never throws. */
public final class M12Parser {

  private final M12Framer framer = new M12Framer();
  private final Consumer<? super M12Message> messages;
  private long malformed;

  /**
   * @param messages is given every message, in order, during {@link #feed} and {@link #finish}
   */
  public M12Parser(Consumer<? super M12Message> messages) {
    this.messages = messages;
  }

  /** Decodes a whole recording. */
  public static List<M12Message> parse(byte[] bytes) {
    List<M12Message> found = new ArrayList<>();
    M12Parser parser = new M12Parser(found::add);
    parser.feed(bytes, 0, bytes.length);
    parser.finish();
    return found;
  }

  /** Takes the next bytes; see {@link M12Framer#feed}. */
  public void feed(byte[] bytes, int offset, int length) {
    framer.feed(bytes, offset, length, this::decode);
  }

  /** No more bytes will follow; see {@link M12Framer#finish}. */
  public void finish() {
    framer.finish(this::decode);
  }

  /** What has come so far. */
  public StreamCounts counts() {
    return new StreamCounts(framer.frames(), framer.droppedBytes(), malformed);
  }

  private void decode(byte[] bytes, int offset, int length) {
    M12Message message = M12Decoder.decode(bytes, offset, length);
    if (message instanceof MalformedMessage) {
      malformed++;
    }
    messages.accept(message);
  }
}
