package org.dfra.drivers.gps.gpsd;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import java.util.Random;
import org.dfra.drivers.fixture.FrameScannerContract;
import org.dfra.drivers.fixture.Sentences;
import org.dfra.drivers.frame.FrameScanner;
import org.dfra.drivers.gps.gpsd.GpsdParser.GpsdFramer;
import org.junit.jupiter.api.Test;

class GpsdFramerTest extends FrameScannerContract {

  @Override
  protected FrameScanner scanner() {
    return new GpsdFramer();
  }

  @Override
  protected void decode(byte[] bytes, int offset, int length) {
    assertThat(GpsdDecoder.decode(bytes, offset, length)).isNotNull();
  }

  @Override
  protected byte[] frame(Random random) {
    String line =
        switch (random.nextInt(4)) {
          case 0 ->
              String.format(
                  Locale.ROOT,
                  "{\"class\":\"TPV\",\"mode\":3,\"time\":\"2026-01-21T07:33:30.000Z\",\"lat\":%.9f,"
                      + "\"lon\":%.9f,\"altHAE\":55.91}",
                  random.nextDouble() * 100 - 50,
                  random.nextDouble() * 300 - 150);
          case 1 ->
              "{\"class\":\"SKY\",\"pdop\":1.5,\"satellites\":["
                  + "{\"PRN\":14,\"el\":41.0,\"az\":60.0,\"ss\":47.0,\"used\":true},"
                  + "{\"PRN\":"
                  + random.nextInt(99)
                  + ",\"used\":false}]}";
          case 2 ->
              "{\"class\":\"DEVICES\",\"devices\":[{\"class\":\"DEVICE\",\"path\":\"/dev/ttyS0\"}]}";
          default -> "{\"class\":\"WATCH\",\"enable\":true,\"remark\":\"\\\"}\\\\\"}";
        };
    return Sentences.bytes(line + "\r\n");
  }

  @Override
  protected String alphabet() {
    return "{\"class\":\"TPV\",\"mode\":3}\r\n[]\\";
  }

  @Test
  void aCutLineDoesNotCostTheNext() {
    String line = "{\"class\":\"TPV\",\"mode\":1}\r\n";
    for (int cut = 0; cut < line.length() - 3; cut++) {
      assertThat(GpsdParser.parse(Sentences.bytes(line.substring(0, cut) + line)))
          .as("cut after %d", cut)
          .hasSize(1)
          .allMatch(GpsdMessage.Tpv.class::isInstance);
    }
  }
}
