package org.dfra.drivers.gps.nmea;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dfra.drivers.fixture.FrameScannerContract;
import org.dfra.drivers.fixture.Sentences;
import org.dfra.drivers.frame.FrameScanner;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.gps.nmea.NmeaParser.NmeaFramer;
import org.junit.jupiter.api.Test;

class NmeaFramerTest extends FrameScannerContract {

  private static final String FIELDS = "0123456789.,,-AEMNSVW";
  private static final String[] TYPES = {"GPRMC", "GNGGA", "GLGSV", "GNGSA", "GPVTG", "PUBX"};

  private final NmeaDecoder decoder = new NmeaDecoder();

  @Override
  protected FrameScanner scanner() {
    return new NmeaFramer();
  }

  @Override
  protected void decode(byte[] bytes, int offset, int length) {
    assertThat(decoder.decode(bytes, offset, length)).isNotNull();
  }

  @Override
  protected byte[] frame(Random random) {
    StringBuilder body = new StringBuilder(TYPES[random.nextInt(TYPES.length)]).append(',');
    for (int left = random.nextInt(70); left > 0; left--) {
      body.append(FIELDS.charAt(random.nextInt(FIELDS.length())));
    }
    return Sentences.with(body.toString());
  }

  @Override
  protected String alphabet() {
    return "$GPGGARMCGSV,.0123456789*\r\n";
  }

  @Test
  void takesSentencesWithoutChecksumUntilOneHasCome() {
    List<NmeaSentence> received = new ArrayList<>();
    NmeaParser parser = new NmeaParser(received::add);
    byte[] bare = Sentences.bytes("$GPGGA,,,,,,0,,,,,,,,\n");
    byte[] checked = Sentences.with("GPGGA,,,,,,0,,,,,,,,");
    parser.feed(bare, 0, bare.length);
    assertThat(received).hasSize(1);
    parser.feed(checked, 0, checked.length);
    parser.feed(bare, 0, bare.length);
    assertThat(received).hasSize(2);
    assertThat(parser.counts()).isEqualTo(new StreamCounts(2, bare.length, 0));
    parser.finish();
    parser.feed(bare, 0, bare.length);
    assertThat(received).as("a new stream").hasSize(3);
  }

  @Test
  void dropsWhatIsNoSentence() {
    for (String line :
        List.of(
            "$GPGGA,,,,,,0,,,,,,,,*00\r\n", // wrong checksum
            "$GPGGA,,,,,,0,,,,,,,,*5\r\n", // half a checksum
            "$GPGGA,,,,\t,,0,,,,,,,,\r\n",
            "$GP\r\n",
            "$" + "G".repeat(300) + "\r\n",
            "GPGGA,,,,,,0,,,,,,,,\r\n")) {
      assertThat(NmeaParser.parse(Sentences.bytes(line))).as(line).isEmpty();
    }
  }
}
