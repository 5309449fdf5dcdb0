package org.dfra.drivers.frame;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * Parses bytes into messages: combines a scanner and a decoder. Confined to one thread. Never
 * throws, whatever the bytes.
 *
 * @param <M> type of the messages
 */
public abstract class FrameParser<M> implements StreamParser {

  /** Decodes intact frames. */
  @FunctionalInterface
  public interface Decoder<M> {

    /**
     * Decodes one frame; must not throw, whatever its content.
     *
     * @param bytes holds it; valid only during the call
     * @param offset index of its first byte
     * @param length its length in bytes
     */
    M decode(byte[] bytes, int offset, int length);
  }

  private final FrameScanner scanner;
  private final Decoder<? extends M> decoder;
  private final Predicate<? super M> isMalformed;
  private final Consumer<? super M> messages;
  private final FrameScanner.Sink sink = this::decode; // made once: feeding allocates no memory
  private long malformed;

  /**
   * @param scanner finds the frames
   * @param decoder decodes them
   * @param isMalformed whether a message represents invalid values
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  protected FrameParser(
      FrameScanner scanner,
      Decoder<? extends M> decoder,
      Predicate<? super M> isMalformed,
      Consumer<? super M> messages) {
    this.scanner = scanner;
    this.decoder = decoder;
    this.isMalformed = isMalformed;
    this.messages = messages;
  }

  /** Decodes a whole recording, with a parser made by {@code make}. */
  protected static <M> List<M> parse(
      byte[] bytes, Function<Consumer<M>, ? extends FrameParser<M>> make) {
    List<M> found = new ArrayList<>();
    FrameParser<M> parser = make.apply(found::add);
    parser.feed(bytes, 0, bytes.length);
    parser.finish();
    return found;
  }

  /** {@inheritDoc} See {@link FrameScanner#feed}. */
  @Override
  public final void feed(byte[] bytes, int offset, int length) {
    scanner.feed(bytes, offset, length, sink);
  }

  /** {@inheritDoc} See {@link FrameScanner#finish}. */
  @Override
  public final void finish() {
    scanner.finish(sink);
  }

  @Override
  public final StreamCounts counts() {
    return new StreamCounts(scanner.frames(), scanner.droppedBytes(), malformed);
  }

  private void decode(byte[] bytes, int offset, int length) {
    M message = decoder.decode(bytes, offset, length);
    if (isMalformed.test(message)) {
      malformed++;
    }
    messages.accept(message);
  }
}
