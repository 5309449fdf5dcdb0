package org.dfra.report.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Rectangle2D;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What lies below one another on a page was at the same time. */
class StackedPanelsTest {

  private static final Axis TIME = Axis.of("time", "s");

  private static LinePanel panel(double from, double to, double most) {
    return new LinePanel("", TIME, Axis.of("distance", "m"))
        .add(Series.line("", new double[] {from, to}, new double[] {0, most}));
  }

  @Test
  void panelsOneBelowTheOtherShareTheirTimeAxis() {
    List<LinePanel> stacked = List.of(panel(0, 100, 1), panel(40, 60, 123_456));
    LinePanel.align(stacked, 1188, 250);
    Plot upper = stacked.get(0).plot(1188, 250);
    Plot lower = stacked.get(1).plot(1188, 250);
    Rectangle2D one = upper.measured();
    Rectangle2D other = lower.measured();
    assertThat(other.getMinX()).as("left ends").isCloseTo(one.getMinX(), within(1.0));
    assertThat(other.getMaxX()).as("right ends").isCloseTo(one.getMaxX(), within(1.0));
    for (double time : new double[] {0, 40, 60, 100}) {
      assertThat(lower.x(time)).as("%s s", time).isCloseTo(upper.x(time), within(1.0));
    }
  }

  @Test
  void onlyThoseOverTheSameQuantityShareIt() {
    LinePanel other = new LinePanel("", Axis.of("vehicles", ""), Axis.of("messages", ""));
    assertThat(panel(0, 1, 1).isOverTheSameAs(panel(5, 6, 7))).isTrue();
    assertThat(panel(0, 1, 1).isOverTheSameAs(other)).isFalse();
  }
}
