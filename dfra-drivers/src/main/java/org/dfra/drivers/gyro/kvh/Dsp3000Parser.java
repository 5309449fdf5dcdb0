package org.dfra.drivers.gyro.kvh;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.frame.FrameScanner;

/** Parses bytes into messages: combines {@link Dsp3000Framer} and {@link Dsp3000Decoder}. */
final class Dsp3000Parser extends FrameParser<Dsp3000Message> {

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

  /**
   * Finds complete lines: from the line feed of the previous line to the carriage return, with only
   * characters of numbers. There is no checksum; the required line feed before each line prevents
   * the remainder of a truncated line from being read as a smaller number.
   */
  static final class Dsp3000Framer extends FrameScanner {

    /** Longest line, its line feed included. */
    public static final int LONGEST = 40;

    /** A framer at the beginning of a stream. */
    public Dsp3000Framer() {
      super(LONGEST);
    }

    @Override
    protected int frameLengthAt(byte[] bytes, int at, int end) {
      if (bytes[at] != '\n') {
        return NONE;
      }
      int limit = Math.min(end, at + LONGEST);
      for (int i = at + 1; i < limit; i++) {
        byte next = bytes[i];
        if (next == '\r') {
          return i == at + 1 ? NONE : i + 1 - at;
        }
        boolean isDigit = next >= '0' && next <= '9';
        if (!isDigit && next != ' ' && next != '.' && next != '-' && next != '+') {
          return NONE;
        }
      }
      return end - at < LONGEST ? NEEDS_MORE : NONE;
    }
  }

  /**
   * Decodes the lines that a {@link Dsp3000Parser.Dsp3000Framer} has found. Never throws, whatever
   * the bytes.
   */
  static final class Dsp3000Decoder {

    /** Maximum rate that the gyro measures, degrees per second. */
    public static final double FASTEST = 375;

    private static final Pattern LINE =
        Pattern.compile("\\s*([-+]?[0-9]{1,6}(?:\\.[0-9]{0,12})?)\\s+([01])\\s*");

    private Dsp3000Decoder() {}

    /** Decodes one line. */
    public static Dsp3000Message decode(byte[] bytes, int offset, int length) {
      String line = new String(bytes, offset, length, StandardCharsets.US_ASCII);
      Matcher matcher = LINE.matcher(line);
      if (matcher.matches()) {
        double rate = Double.parseDouble(matcher.group(1));
        if (Math.abs(rate) <= FASTEST) {
          return new Dsp3000Message.Rate(rate, matcher.group(2).equals("1"));
        }
      }
      return new Dsp3000Message.Malformed(line.strip());
    }
  }
}
