package org.dfra.drivers.gps.m12;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HexFormat;
import org.junit.jupiter.api.Test;

/** The expected bytes are the ready frames of the user's guide. */
class M12CommandsTest {

  private static final HexFormat HEX = HexFormat.ofDelimiter(" ").withUpperCase();

  @Test
  void writesTheReadyFramesOfTheGuide() {
    assertThat(hex(M12Commands.positionOf12Channels(1))).isEqualTo("40 40 48 61 01 28 0D 0A");
    assertThat(hex(M12Commands.identification())).isEqualTo("40 40 43 6A 29 0D 0A");
    assertThat(hex(M12Commands.utcTime())).isEqualTo("40 40 41 77 01 37 0D 0A");
    assertThat(hex(M12Commands.encode("Hb", 1))).isEqualTo("40 40 48 62 01 2B 0D 0A");
    assertThat(hex(M12Commands.encode("Hn", 1))).isEqualTo("40 40 48 6E 01 27 0D 0A");
    assertThat(hex(M12Commands.encode("Cf"))).isEqualTo("40 40 43 66 25 0D 0A");
  }

  @Test
  void putsTheRateIntoCommandAndChecksum() {
    // E xor a xor rate
    assertThat(hex(M12Commands.positionOf8Channels(0))).isEqualTo("40 40 45 61 00 24 0D 0A");
    assertThat(hex(M12Commands.positionOf8Channels(255))).isEqualTo("40 40 45 61 FF DB 0D 0A");
  }

  @Test
  void refusesRatesTheReceiverDoesNotHave() {
    assertThatThrownBy(() -> M12Commands.positionOf12Channels(256))
        .hasMessage("rate 256 s is outside 0 to 255 s");
    assertThatThrownBy(() -> M12Commands.positionOf8Channels(-1))
        .hasMessage("rate -1 s is outside 0 to 255 s");
  }

  private static String hex(byte[] bytes) {
    return HEX.formatHex(bytes);
  }
}
