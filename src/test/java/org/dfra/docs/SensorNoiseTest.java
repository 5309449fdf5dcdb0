package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The figures of {@code docs/reference/sensor-noise.md} are those of the two references. */
class SensorNoiseTest {

  private static final Pattern ROW =
      Pattern.compile(
          "(?m)^\\| `(\\w+)` \\| `(\\w+)` \\| ([\\d.]+) \\| (?:`(\\w+)`)? ?\\| ?([\\d.]*) ?\\|");

  @Test
  void repeatsTheDefaultsOfTheSimulationAndOfTheEstimators() {
    String world = Documents.of("docs/reference/world-xml.md").text();
    String behaviors = Documents.of("docs/reference/behaviors.md").text();
    List<MatchResult> rows =
        ROW.matcher(Documents.of("docs/reference/sensor-noise.md").text()).results().toList();
    assertThat(rows).hasSizeGreaterThan(10);
    for (MatchResult row : rows) {
      String device = world.substring(world.indexOf("\n### `" + row.group(1) + "`\n"));
      same(row, row.group(3), number(device, row.group(2)));
      if (row.group(4) != null) {
        same(row, row.group(5), number(behaviors, row.group(4)));
      }
    }
  }

  private static String number(String text, String parameter) {
    return Pattern.compile("\\| `" + parameter + "` \\| ([-\\d.E]+)")
        .matcher(text)
        .results()
        .findFirst()
        .orElseThrow(() -> new AssertionError("no parameter " + parameter + " with a default"))
        .group(1);
  }

  private static void same(MatchResult row, String here, String there) {
    assertThat(new BigDecimal(here)).as(row.group()).isEqualByComparingTo(new BigDecimal(there));
  }
}
