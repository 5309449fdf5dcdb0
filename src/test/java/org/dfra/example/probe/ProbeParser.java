package org.dfra.example.probe;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.frame.FrameScanner;

/**
 * Bytes in, degrees Celsius out; NaN for an intact line that tells no temperature from −55 to 125.
 */
final class ProbeParser extends FrameParser<Double> {

  ProbeParser(Consumer<Double> celsius) {
    super(new Lines(), ProbeParser::celsius, value -> value.isNaN(), celsius);
  }

  /** Has the probe tell its temperature once in so many seconds, 1 to 60. */
  static byte[] order(double seconds) {
    return ("P" + seconds + "\n").getBytes(US_ASCII);
  }

  static double celsius(byte[] bytes, int offset, int length) {
    String text = new String(bytes, offset + 1, 7, US_ASCII);
    double celsius = text.matches("[+-]\\d{3}\\.\\d\\d") ? Double.parseDouble(text) : Double.NaN;
    return celsius >= -55 && celsius <= 125 ? celsius : Double.NaN;
  }

  /** {@code T+021.50*hh\n}, where hh is the exclusive or of all that stands before the star. */
  static final class Lines extends FrameScanner {

    private static final int LENGTH = 12;

    Lines() {
      super(LENGTH);
    }

    @Override
    protected int frameLengthAt(byte[] bytes, int at, int end) {
      if (bytes[at] != 'T') {
        return NONE;
      }
      if (end - at < LENGTH) {
        return NEEDS_MORE;
      }
      int sum = 0;
      for (int i = at; i < at + 8; i++) {
        sum ^= bytes[i];
      }
      boolean intact =
          bytes[at + 8] == '*'
              && Character.digit(bytes[at + 9], 16) == sum >> 4
              && Character.digit(bytes[at + 10], 16) == (sum & 15)
              && bytes[at + 11] == '\n';
      return intact ? LENGTH : NONE;
    }
  }
}
