package org.dfra.drivers.gps.nmea;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.StreamCounts;

/** Bytes in, sentences out: framer and decoder in one. Confined to one thread. Never throws. */
public final class NmeaParser {

  private final NmeaFramer framer = new NmeaFramer();
  private final NmeaDecoder decoder = new NmeaDecoder();
  private final Consumer<? super NmeaSentence> sentences;
  private long malformed;

  /**
   * @param sentences is given every sentence, in order, during {@link #feed} and {@link #finish}
   */
  public NmeaParser(Consumer<? super NmeaSentence> sentences) {
    this.sentences = sentences;
  }

  /** Decodes a whole recording. */
  public static List<NmeaSentence> parse(byte[] bytes) {
    List<NmeaSentence> found = new ArrayList<>();
    NmeaParser parser = new NmeaParser(found::add);
    parser.feed(bytes, 0, bytes.length);
    parser.finish();
    return found;
  }

  /** Takes the next bytes; see {@link NmeaFramer#feed}. */
  public void feed(byte[] bytes, int offset, int length) {
    framer.feed(bytes, offset, length, this::decode);
  }

  /** No more bytes will follow; see {@link NmeaFramer#finish}. */
  public void finish() {
    framer.finish(this::decode);
  }

  /** What has come so far. */
  public StreamCounts counts() {
    return new StreamCounts(framer.frames(), framer.droppedBytes(), malformed);
  }

  private void decode(byte[] bytes, int offset, int length) {
    NmeaSentence sentence = decoder.decode(bytes, offset, length);
    if (sentence instanceof NmeaSentence.Malformed) {
      malformed++;
    }
    sentences.accept(sentence);
  }
}
