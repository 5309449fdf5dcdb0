package org.dfra.drivers.laser.lms;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;
import org.dfra.drivers.laser.lms.LmsMessage.LmsError;
import org.dfra.drivers.laser.lms.LmsMessage.Malformed;
import org.junit.jupiter.api.Test;

class LmsDecoderTest {

  @Test
  void readsAnAnswerAsItComesOverTheLine() {
    byte[] bytes = HexFormat.of().parseHex("06" + "02800300A000" + "10" + "160A");
    assertThat(LmsParser.parse(bytes)).containsExactly(new LmsMessage.ModeReply(0, StatusByte.OK));
    byte[] refused = HexFormat.of().parseHex("06" + "0280020092" + "10" + "7F33");
    assertThat(LmsParser.parse(refused))
        .containsExactly(new LmsMessage.RefusedReply(StatusByte.OK));
    byte[] resets = HexFormat.of().parseHex("0280020091" + "10" + "7930");
    assertThat(LmsParser.parse(resets)).containsExactly(new LmsMessage.ResetReply(StatusByte.OK));
  }

  @Test
  void readsScansOfEveryUnitWithAndWithoutCounters() {
    int[] samples = {0, 1, 8191, 65_535, 300};
    assertThat(decode(Replies.scan(0, samples)))
        .isEqualTo(new LmsScan(LmsUnit.CM, samples, -1, StatusByte.OK));
    assertThat(decode(Replies.scan(1, samples, 7)))
        .isEqualTo(new LmsScan(LmsUnit.MM, samples, 7, StatusByte.OK));
    assertThat(decode(Replies.scan(2, samples, 255, 3)))
        .isEqualTo(new LmsScan(LmsUnit.DM, samples, 255, StatusByte.OK));
  }

  @Test
  void aScanThatCannotBeIsMalformed() {
    assertThat(decode(Replies.telegram(0xB0, 2, 0, 1, 1)))
        .isEqualTo(new Malformed("B0", "2 samples do not fit 2 bytes"));
    assertThat(decode(Replies.scan(3, new int[2]))).isInstanceOf(Malformed.class);
    assertThat(decode(Replies.telegram(0xB0, 0, 0))).isInstanceOf(Malformed.class);
    assertThat(decode(Replies.telegram(0xB0, 0))).isInstanceOf(Malformed.class);
    assertThat(decode(Replies.telegram(0xB0))).isInstanceOf(Malformed.class);
    assertThat(decode(Replies.telegram(0xB0, 1, 0x20, 5, 5)))
        .isEqualTo(new Malformed("B0", "it is a part of a scan, which was not requested"));
  }

  @Test
  void readsVariants() {
    assertThat(decode(Replies.telegram(0xBB, 1, 100, 0, 25, 0)))
        .isEqualTo(new LmsMessage.VariantReply(true, new LmsVariant(100, 25), StatusByte.OK));
    assertThat(decode(Replies.telegram(0xBB, 0, 180, 0, 50, 0)))
        .isEqualTo(new LmsMessage.VariantReply(false, new LmsVariant(180, 50), StatusByte.OK));
    assertThat(decode(Replies.telegram(0xBB, 1, 180, 0, 25, 0)))
        .isEqualTo(new Malformed("BB", "180° by 0.01 × 25° are no variant"));
    assertThat(decode(Replies.telegram(0xBB, 1))).isInstanceOf(Malformed.class);
  }

  @Test
  void readsConfigurations() {
    int[] data = new int[34];
    data[5] = 6;
    data[6] = 1;
    LmsMessage.ConfigurationReply reported =
        (LmsMessage.ConfigurationReply) decode(Replies.telegram(0xF4, data));
    assertThat(reported.configuration().mode()).contains(new MeasuringMode(6, 15));
    assertThat(reported.configuration().unit()).contains(LmsUnit.MM);
    int[] answer = new int[35];
    answer[0] = 1;
    answer[6] = 9;
    answer[7] = 7;
    LmsMessage.ConfigurationChangeReply set =
        (LmsMessage.ConfigurationChangeReply) decode(Replies.telegram(0xF7, answer));
    assertThat(set.isDone()).isTrue();
    assertThat(set.configuration().modeCode()).isEqualTo(9);
    assertThat(set.configuration().mode()).isEmpty();
    assertThat(set.configuration().unit()).isEmpty();
    assertThat(decode(Replies.telegram(0xF4, 1, 2, 3))).isInstanceOf(Malformed.class);
    assertThat(decode(Replies.telegram(0xF7, new int[60]))).isInstanceOf(Malformed.class);
  }

  @Test
  void readsTypesAndErrors() {
    int[] type = "LMS200;30106;V02.30 ".chars().toArray();
    assertThat(decode(Replies.telegram(0xBA, type)))
        .isEqualTo(new LmsMessage.TypeReply(false, "LMS200;30106;V02.30", StatusByte.OK));
    assertThat(decode(Replies.telegram(0x90, type)))
        .isEqualTo(new LmsMessage.TypeReply(true, "LMS200;30106;V02.30", StatusByte.OK));
    assertThat(decode(Replies.telegram(0xB2, 0x02, 21, 0x83, 5)))
        .isEqualTo(
            new LmsMessage.ErrorsReply(
                List.of(new LmsError(2, 21), new LmsError(0x83, 5)), StatusByte.OK));
    assertThat(new LmsError(2, 21).inWords()).isEqualTo("error 21 (WARNING)");
    assertThat(new LmsError(0x83, 5).inWords()).isEqualTo("error 5 (ERROR, over)");
    assertThat(decode(Replies.telegram(0xB2, 1))).isInstanceOf(Malformed.class);
    assertThat(decode(Replies.telegram(0xC5, 1, 2)))
        .isEqualTo(new LmsMessage.Other(0xC5, StatusByte.OK));
    assertThat(decode(Replies.telegram(0xA0))).isInstanceOf(Malformed.class);
  }

  @Test
  void readsAStatus() {
    int[] data = new int[152];
    byte[] version = "V02.30 ".getBytes(StandardCharsets.US_ASCII);
    for (int i = 0; i < version.length; i++) {
      data[i] = version[i]; // offsets in data are one less than in the reply
    }
    data[7] = 0x24;
    for (int i = 0; i < 8; i++) {
      put(data, 18 + 2 * i, 200 - 10 * i);
      put(data, 42 + 2 * i, 200);
    }
    put(data, 66, 4500);
    put(data, 82, 97);
    data[101] = 3;
    put(data, 106, 100);
    put(data, 108, 25);
    put(data, 115, 0x8019);
    data[121] = 1;
    assertThat(decode(Replies.telegram(0xB1, data)))
        .isEqualTo(
            new LmsStatus(
                "V02.30",
                0x24,
                false,
                List.of(100, 95, 90, 85, 80, 75, 70, 65),
                4500,
                97,
                3,
                Optional.of(new LmsVariant(100, 25)),
                Optional.of(LmsUnit.MM),
                Optional.of(LmsBaud.B38400),
                false,
                StatusByte.OK));
    assertThat(decode(Replies.telegram(0xB1, new int[100]))).isInstanceOf(Malformed.class);
    LmsStatus bare = (LmsStatus) decode(Replies.telegram(0xB1, new int[152]));
    assertThat(bare.variant()).isEmpty();
    assertThat(bare.baud()).isEmpty();
    assertThat(bare.pollution()).as("never calibrated").containsOnly(100);
  }

  @Test
  void readsTheStatusByte() {
    assertThat(new StatusByte(0x10).isSound()).isTrue();
    assertThat(new StatusByte(0x11).isSound()).isTrue();
    assertThat(new StatusByte(0x12).isSound()).isFalse();
    assertThat(new StatusByte(0x90).inWords()).isEqualTo("severity NONE, window dirty");
    assertThat(new StatusByte(0x54).inWords()).isEqualTo("severity FATAL, values not plausible");
    assertThat(new StatusByte(0x17).severity()).isEqualTo(StatusByte.Severity.UNKNOWN);
  }

  private static LmsMessage decode(byte[] frame) {
    List<LmsMessage> found = LmsParser.parse(frame);
    assertThat(found).hasSize(1);
    return found.get(0);
  }

  private static void put(int[] data, int at, int value) {
    data[at] = value & 0xFF;
    data[at + 1] = value >> 8;
  }
}
