package org.dfra.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import org.dfra.sim.run.GroundTruthLog.GroundTruthRow;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.junit.jupiter.api.Test;

class GroundTruthRowTest {

  private static final GroundTruthRow ROW =
      new GroundTruthRow(
          "atrv1",
          new GroundTruthPose(
              Instant.parse("2026-06-01T12:00:00.1Z"),
              1.5,
              -2.25,
              0.125,
              0,
              0,
              -3.14,
              0.009,
              0,
              0,
              0.5));

  @Test
  void whatIsWrittenIsRead() {
    assertThat(ROW.line())
        .isEqualTo(
            "2026-06-01T12:00:00.100Z,atrv1,1.5000,-2.2500,0.1250,-3.14000,0.0090,0.0000,0.50000");
    assertThat(GroundTruthRow.parse(ROW.line())).hasValue(ROW);
    assertThat(GroundTruthRow.parse(ROW.line() + "\r")).as("from another system").hasValue(ROW);
    assertThat(ROW.pose().isStopped()).as("9 mm/s").isTrue();
  }

  @Test
  void headingsAndIncompleteLinesAreNoRows() {
    assertThat(GroundTruthRow.parse(GroundTruthRow.HEADER)).isEmpty();
    assertThat(GroundTruthRow.parse("2026-06-01T12:00:00.1Z,atrv1,1.5")).isEmpty();
    assertThat(GroundTruthRow.parse("")).isEmpty();
  }

  @Test
  void aLineWithoutNumbersIsRefused() {
    assertThatThrownBy(() -> GroundTruthRow.parse("a,b,c,d,e,f,g,h,i"))
        .isInstanceOf(NumberFormatException.class);
  }
}
