package org.dfra.drivers.gyro.kvh;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.dfra.drivers.fixture.FrameScannerContract;
import org.dfra.drivers.frame.FrameScanner;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.gyro.kvh.Dsp3000Message.Malformed;
import org.dfra.drivers.gyro.kvh.Dsp3000Message.Rate;
import org.dfra.drivers.gyro.kvh.Dsp3000Parser.Dsp3000Decoder;
import org.dfra.drivers.gyro.kvh.Dsp3000Parser.Dsp3000Framer;
import org.junit.jupiter.api.Test;

class Dsp3000FramerTest extends FrameScannerContract {

  @Override
  protected FrameScanner scanner() {
    return new Dsp3000Framer();
  }

  @Override
  protected void decode(byte[] bytes, int offset, int length) {
    assertThat(Dsp3000Decoder.decode(bytes, offset, length)).isNotNull();
  }

  @Override
  protected byte[] frame(Random random) {
    double rate = (random.nextDouble() - 0.5) * 750;
    return bytes(String.format(Locale.ROOT, "\n%11.6f %d\r", rate, random.nextInt(2)));
  }

  @Override
  protected String alphabet() {
    return "0123456789.-+ \r\n";
  }

  @Test
  void readsRatesAndWhetherTheyAreValid() {
    assertThat(
            Dsp3000Parser.parse(
                bytes("\r\n12.345678 1\r\n-0.001234 1\r\n   3.5   0 \r\n+7 1\r\n-375.0 1\r\n")))
        .containsExactly(
            new Rate(12.345678, true),
            new Rate(-0.001234, true),
            new Rate(3.5, false),
            new Rate(7, true),
            new Rate(-375, true));
  }

  @Test
  void takesTheRestOfACutLineForNothing() {
    assertThat(Dsp3000Parser.parse(bytes("2.345678 1\r\n-0.5 1\r\n")))
        .as("it may have been -12.345678")
        .containsExactly(new Rate(-0.5, true));
    assertThat(Dsp3000Parser.parse(bytes("\n-0.5\n1.5 1\r"))).containsExactly(new Rate(1.5, true));
  }

  @Test
  void countsWhatCannotBe() {
    List<String> lines =
        List.of(
            "375.1 1",
            "-1000 1",
            "1.5",
            "1.5 2",
            "1.5 1 1",
            "1-5 1",
            "..",
            "1.2.3 1",
            "12345678 0");
    Dsp3000Parser parser =
        new Dsp3000Parser(
            message -> assertThat(message).as("%s", message).isInstanceOf(Malformed.class));
    for (String line : lines) {
      byte[] bytes = bytes("\n" + line + "\r");
      parser.feed(bytes, 0, bytes.length);
    }
    parser.finish();
    assertThat(parser.counts()).isEqualTo(new StreamCounts(lines.size(), 0, lines.size()));
    assertThat(Dsp3000Parser.parse(bytes("\n1.5 x\r\n\r\n" + "1".repeat(60) + "\r"))).isEmpty();
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.US_ASCII);
  }
}
