package org.dfra.drivers.gyro.kvh;

import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Decodes the lines that a {@link Dsp3000Framer} has found. Never throws, whatever the bytes. */
public final class Dsp3000Decoder {

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
