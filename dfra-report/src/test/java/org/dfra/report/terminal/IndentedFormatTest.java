package org.dfra.report.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.flow.sensor.RangeScan;
import org.junit.jupiter.api.Test;

class IndentedFormatTest {

  private static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");

  private static RangeScan scan() {
    float[] ranges = new float[361];
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = i == 7 ? Float.POSITIVE_INFINITY : 1 + i / 360f;
    }
    return new RangeScan(NOON, "atrv1/laser", -1.5, 0.01, 0.03, 0, 8, ranges);
  }

  @Test
  void sumsUpWhatNobodyReadsOneByOne() {
    assertThat(IndentedFormat.of(scan())).contains("ranges: 361 numbers, 1 to 2");
    assertThat(InlineFormat.of(scan())).endsWith("ranges 361 numbers, 1 to 2");
  }

  /** A record whose outline has long lines. */
  record Parameter(String name, String meaning) {}

  @Test
  void aLineThatIsTooLongGoesOnBelowIt() {
    Parameter rate = new Parameter("rate", "from one position to the next, 1 to 255 s");
    List<String> lines =
        IndentedFormat.of(List.of(rate)).stream()
            .flatMap(line -> IndentedFormat.folded(line, 40).stream())
            .toList();
    assertThat(lines)
        .containsExactly(
            "- name: rate", "  meaning: from one position to the", "      next, 1 to 255 s");
  }

  /** Numbers as measured, one large and one small. */
  record Figures(double latitude, double noise, double whole) {}

  @Test
  void peopleGetAsManyDigitsAsTheyCanUse() {
    Figures figures = new Figures(48.000085123456, 0.000000123456, 3);
    assertThat(InlineFormat.of(figures))
        .isEqualTo("latitude 48.0000851, noise 0.0000001235, whole 3");
    assertThat(Json.line(figures)).contains("48.000085123456");
  }

  @Test
  void countsTheBytesOfAnImage() {
    CameraImage image =
        new CameraImage(
            NOON, "atrv1/camera", Band.VISIBLE, 320, 240, 300, "image/jpeg", new byte[999]);

    assertThat(IndentedFormat.of(image)).contains("data: 999 bytes");
  }

  @Test
  void printsEveryNumberForPrograms() {
    assertThat(Json.line(scan())).contains("\"ranges\":[1.0,").contains("\"Infinity\"");
  }
}
