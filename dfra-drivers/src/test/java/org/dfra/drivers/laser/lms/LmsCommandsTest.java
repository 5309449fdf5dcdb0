package org.dfra.drivers.laser.lms;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HexFormat;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;
import org.junit.jupiter.api.Test;

/** The telegrams of the telegram listing, byte by byte. */
class LmsCommandsTest {

  @Test
  void writesTheTelegramsOfTheListing() {
    assertTelegram(LmsCommands.reset(), "02 00 01 00 10 34 12");
    assertTelegram(LmsCommands.stream(), "02 00 02 00 20 24 34 08");
    assertTelegram(LmsCommands.stop(), "02 00 02 00 20 25 35 08");
    assertTelegram(LmsCommands.baud(LmsBaud.B38400), "02 00 02 00 20 40 50 08");
    assertTelegram(LmsCommands.baud(LmsBaud.B19200), "02 00 02 00 20 41 51 08");
    assertTelegram(LmsCommands.baud(LmsBaud.B9600), "02 00 02 00 20 42 52 08");
    assertTelegram(LmsCommands.baud(LmsBaud.B500000), "02 00 02 00 20 48 58 08");
    assertTelegram(LmsCommands.installation(), "02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5");
    assertTelegram(LmsCommands.status(), "02 00 01 00 31 15 12");
    assertTelegram(LmsCommands.type(), "02 00 01 00 3A 1E 12");
    assertTelegram(LmsCommands.configuration(), "02 00 01 00 74 50 12");
    assertTelegram(LmsCommands.scan(), "02 00 02 00 30 01 31 18");
  }

  @Test
  void writesTheVariantsOfTheListing() {
    assertTelegram(
        LmsCommands.variant(new LmsVariant(180, 50)), "02 00 05 00 3B B4 00 32 00 3B 1F");
    assertTelegram(
        LmsCommands.variant(new LmsVariant(180, 100)), "02 00 05 00 3B B4 00 64 00 97 49");
    assertTelegram(
        LmsCommands.variant(new LmsVariant(100, 25)), "02 00 05 00 3B 64 00 19 00 E7 72");
  }

  @Test
  void writesAConfigurationBackAsItIsButForWhatIsWanted() {
    byte[] bytes = new byte[34];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) (100 + i);
    }
    LmsConfiguration reported = new LmsConfiguration(bytes);
    byte[] telegram =
        LmsCommands.configure(reported.with(LmsUnit.MM).with(MeasuringMode.of(6).orElseThrow()));
    bytes[5] = 6;
    bytes[6] = 1;
    assertThat(telegram).hasSize(41).startsWith(2, 0, 35, 0, 0x77);
    assertThat(telegram).containsSubsequence(bytes);
    assertThat(reported.modeCode()).as("the reported one is not changed").isEqualTo(105);
  }

  private static void assertTelegram(byte[] telegram, String hex) {
    assertThat(HexFormat.ofDelimiter(" ").withUpperCase().formatHex(telegram)).isEqualTo(hex);
  }
}
