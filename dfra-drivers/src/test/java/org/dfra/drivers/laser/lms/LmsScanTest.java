package org.dfra.drivers.laser.lms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.dfra.drivers.fixture.SharedData;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;
import org.dfra.drivers.laser.lms.LmsParser.LmsCrc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Samples as distances, of chosen scans and of a recorded one. */
class LmsScanTest {

  private static final String RECORDING = "laser/sick_lms_b0_361_usick.bin";

  @ParameterizedTest
  @CsvSource({"0,13", "1,13", "2,13", "3,14", "4,14", "5,15", "6,15", "15,16"})
  void theMeasuringModeSaysHowManyBitsAreTheDistance(int code, int bits) {
    MeasuringMode mode = MeasuringMode.of(code).orElseThrow();
    int top = (1 << bits) - 1;
    assertThat(mode.top()).isEqualTo(top);
    assertThat(mode.range(1234, LmsUnit.MM)).isEqualTo(1.234f);
    assertThat(mode.range(1234 | 0xFFFF ^ top, LmsUnit.CM)).isEqualTo(12.34f);
    assertThat(mode.range(top - 9, LmsUnit.MM)).isEqualTo((float) ((top - 9) * 0.001));
    assertThat(mode.range(top - 8, LmsUnit.MM)).isEqualTo(Float.POSITIVE_INFINITY);
    for (int reserved : new int[] {0, 1, 2, 4, 5}) {
      assertThat(mode.range(top - reserved, LmsUnit.MM)).isNaN();
    }
  }

  @Test
  void modesThatNobodyKnowsAreNone() {
    assertThat(IntStream.range(0, 256).filter(code -> MeasuringMode.of(code).isPresent()))
        .containsExactly(0, 1, 2, 3, 4, 5, 6, 15);
  }

  @Test
  void computesItsMaximumRange() {
    assertThat(new MeasuringMode(0, 13).maxRange(LmsUnit.MM)).isCloseTo(8.182, within(1e-9));
    assertThat(new MeasuringMode(0, 13).maxRange(LmsUnit.CM)).isEqualTo(80);
    assertThat(new MeasuringMode(6, 15).maxRange(LmsUnit.MM)).isCloseTo(32.758, within(1e-9));
  }

  @ParameterizedTest
  @CsvSource({"180,100,181,372", "180,50,361,732", "100,25,401,812"})
  void telegramsAreAsLongAsTheListingHasThem(int degrees, int hundredths, int beams, int bytes) {
    LmsVariant variant = new LmsVariant(degrees, hundredths);
    assertThat(variant.beams()).isEqualTo(beams);
    assertThat(variant.telegramBytes()).isEqualTo(bytes);
    assertThat(Replies.scan(1, new int[beams])).hasSize(bytes);
  }

  @Test
  void computesItsTimes() {
    assertThat(new LmsVariant(180, 100).period()).isCloseTo(0.0133, within(1e-4));
    assertThat(new LmsVariant(180, 50).period()).isCloseTo(0.0267, within(1e-4));
    assertThat(new LmsVariant(100, 25).period()).isCloseTo(0.0533, within(1e-4));
    assertThat(new LmsVariant(180, 100).duration())
        .as("half a turn")
        .isCloseTo(1 / 150.0, within(1e-9));
    assertThat(new LmsVariant(180, 50).duration()).isCloseTo(1.5 / 75, within(1e-9));
    assertThat(new LmsVariant(180, 100).rate(38_400)).isCloseTo(10.3, within(0.1));
    assertThat(new LmsVariant(180, 50).rate(38_400)).isCloseTo(5.2, within(0.1));
    assertThat(new LmsVariant(180, 50).rate(500_000)).isEqualTo(37.5);
  }

  @Test
  void beamsTurnFromRightToLeft() {
    LmsVariant variant = new LmsVariant(180, 50);
    assertThat(variant.firstAngle()).isEqualTo(-Math.PI / 2);
    assertThat(variant.firstAngle() + 360 * variant.step()).isCloseTo(Math.PI / 2, within(1e-9));
  }

  @Test
  void decodesTheRecordedTelegramWithEveryFarValueKept() throws Exception {
    byte[] recording = SharedData.bytes(RECORDING);
    assertThat(LmsCrc.of(recording, 0, recording.length - 2)).isEqualTo(0x4764);
    LmsScan scan = (LmsScan) LmsParser.parse(recording).get(0);
    assertThat(scan.unit()).isEqualTo(LmsUnit.MM);
    assertThat(scan.beams()).isEqualTo(361);
    assertThat(scan.index()).isEqualTo(-1);
    assertThat(scan.status()).isEqualTo(StatusByte.OK);
    float[] ranges = scan.ranges(new MeasuringMode(6, 15));
    long far = IntStream.range(0, 361).filter(i -> ranges[i] > 8.191f).count();
    assertThat(far).isEqualTo(89);
    assertThat(ranges[0]).isEqualTo((recording[7] & 0xFF | (recording[8] & 0xFF) << 8) / 1000f);
    float[] masked = scan.ranges(new MeasuringMode(0, 13));
    assertThat(Arrays.equals(masked, ranges)).as("13 bits would corrupt it").isFalse();
  }
}
