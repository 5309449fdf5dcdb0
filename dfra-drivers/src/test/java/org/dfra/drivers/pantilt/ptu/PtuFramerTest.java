package org.dfra.drivers.pantilt.ptu;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.dfra.drivers.fixture.FrameScannerContract;
import org.dfra.drivers.frame.FrameScanner;
import org.dfra.drivers.pantilt.ptu.PtuCommands.PtuAxis;
import org.dfra.drivers.pantilt.ptu.PtuParser.PtuDecoder;
import org.dfra.drivers.pantilt.ptu.PtuParser.PtuFramer;
import org.dfra.drivers.pantilt.ptu.PtuReply.Done;
import org.dfra.drivers.pantilt.ptu.PtuReply.LimitHit;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;
import org.dfra.drivers.pantilt.ptu.PtuReply.Value;
import org.junit.jupiter.api.Test;

/** Replies are the examples of the user's manual, section 4. */
class PtuFramerTest extends FrameScannerContract {

  private static final String TEXT = "0123456789-. abcdefgPTNXRS";

  @Override
  protected FrameScanner scanner() {
    return new PtuFramer();
  }

  @Override
  protected void decode(byte[] bytes, int offset, int length) {
    PtuReply reply = PtuDecoder.decode(bytes, offset, length);
    assertThat(reply).isNotNull();
    if (reply instanceof Value value) {
      assertThat(value.number()).isNotNull();
    }
  }

  @Override
  protected byte[] frame(Random random) {
    if (random.nextInt(4) == 0) {
      return bytes("*\r");
    }
    StringBuilder text = new StringBuilder(random.nextInt(5) == 0 ? "! " : "* ");
    for (int left = 1 + random.nextInt(40); left > 0; left--) {
      text.append(TEXT.charAt(random.nextInt(TEXT.length())));
    }
    return bytes(text.append('\r').toString());
  }

  @Override
  protected String alphabet() {
    return "*!PT \r\n0123456789-.";
  }

  @Test
  void readsTerseAndVerboseReplies() {
    assertThat(PtuParser.parse(bytes("*\r\n* 22\r\n* 185.1428\r\n* -907\r\n")))
        .containsExactly(new Done(), new Value("22"), new Value("185.1428"), new Value("-907"));
    for (String reported :
        new String[] {
          "-3090", "Minimum Pan position is -3090",
        }) {
      assertThat(new Value(reported).number()).hasValue(-3090);
    }
    assertThat(new Value("185.1428 seconds arc per Pan position").number()).hasValue(185.1428);
    assertThat(new Value("Pan-Tilt Controller v2.12.1d1(C14/E), (C)2003").number()).hasValue(2003);
    assertThat(new Value("Input 30 VDC @ 86 degF").number()).isEmpty();
    assertThat(new Value("ASCII terse mode").number()).isEmpty();
    assertThat(new Value("99999999999").number()).isEmpty();
  }

  @Test
  void dropsEchoAndWhatItPrintsWhenItIsSwitchedOn() {
    assertThat(PtuParser.parse(bytes("PP * 22\r\nED *\r\n")))
        .containsExactly(new Value("22"), new Done());
    assertThat(PtuParser.parse(bytes("\r\n### PAN-TILT CONTROLLER\r\nInitializing...\r\n*\r\n")))
        .containsExactly(new Done());
  }

  @Test
  void distinguishesRefusalsFromLimits() {
    assertThat(PtuParser.parse(bytes("! Maximum allowable Pan position is 3090\r\n")))
        .containsExactly(new Refused("Maximum allowable Pan position is 3090"));
    assertThat(PtuParser.parse(bytes("* 1\r!P\r\n* 2\r!T* 3\r!\r")))
        .containsExactly(
            new Value("1"),
            new LimitHit(PtuAxis.PAN),
            new Value("2"),
            new LimitHit(PtuAxis.TILT),
            new Value("3"),
            new Refused(""));
    assertThat(PtuParser.parse(bytes("!Px!T7"))).as("no limit was hit inside of a word").isEmpty();
  }

  @Test
  void dropsWhatHasNoEnd() {
    assertThat(PtuParser.parse(bytes("* 1* 22\r"))).containsExactly(new Value("22"));
    assertThat(PtuParser.parse(bytes("* " + "7".repeat(300) + "\r* 4\r")))
        .containsExactly(new Value("4"));
    assertThat(PtuParser.parse(bytes("* 12\0003\r* 4"))).isEmpty();
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }
}
