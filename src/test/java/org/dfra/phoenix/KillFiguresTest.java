package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.dfra.core.time.Timing;
import org.dfra.report.measurement.MeasuredValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class KillFiguresTest {

  private final KillFigures figures = new KillFigures(Duration.ofSeconds(2));

  @TempDir Path folder;

  private void killed(long millis) {
    figures.killed();
    figures.back(new Timing(Duration.ofMillis(millis), Duration.ZERO, 1));
  }

  /** A hundred kills: 10 ms, 20 ms, ... 1 s, not in order. */
  private void killAHundredTimes() {
    for (int i = 0; i < 100; i++) {
      killed(((i * 37) % 100 + 1) * 10L);
      figures.kept();
    }
  }

  @Test
  void saysHowLongItTookAndWhetherStateWasKept() {
    killAHundredTimes();
    assertThat(figures.figures().all())
        .containsExactly(
            new MeasuredValue("kills", 100, Double.POSITIVE_INFINITY, ""),
            new MeasuredValue("kills after which state was lost", 0, 0, ""),
            new MeasuredValue("back after kill -9, median", 0.5, Double.POSITIVE_INFINITY, "s"),
            new MeasuredValue("back after kill -9, p95", 0.95, 2, "s"),
            new MeasuredValue("back after kill -9, longest", 1, Double.POSITIVE_INFINITY, "s"));
    killed(30_000);
    assertThat(figures.figures().missed())
        .extracting(MeasuredValue::name)
        .containsExactly("kills after which state was lost");
    assertThat(figures.quantile(1).took()).isEqualTo(Duration.ofSeconds(30));
  }

  @Test
  void appendsARowForEachWithDateAndMachine() throws Exception {
    Path file = folder.resolve("killed-module.csv");
    killAHundredTimes();
    figures.record(file);
    figures.record(file);
    List<String> rows = Files.readAllLines(file);
    assertThat(rows).hasSize(11);
    assertThat(rows.get(0)).isEqualTo("when,soak,java,cores,load,figure,measured,target_max,unit");
    String machine =
        "killed-module,%d,%d,"
            .formatted(Runtime.version().feature(), Runtime.getRuntime().availableProcessors());
    assertThat(rows.subList(1, 11))
        .allMatch(
            row -> row.matches("20\\d\\d-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ," + machine + ".*"));
    assertThat(rows.get(1)).endsWith(",\"kills\",100,,");
    assertThat(rows.get(2)).endsWith(",\"kills after which state was lost\",0,0,");
    assertThat(rows.get(4)).endsWith(",\"back after kill -9, p95\",0.95,2,s");
    assertThat(rows.get(9)).endsWith(",\"back after kill -9, p95\",0.95,2,s");
  }

  @Test
  void aKillThatItDoesNotComeBackFromIsRecordedToo() throws Exception {
    Path file = folder.resolve("killed-module.csv");
    figures.killed();
    figures.record(file);
    List<String> rows = Files.readAllLines(file);
    assertThat(rows).hasSize(3);
    assertThat(rows.get(2)).endsWith(",\"kills after which state was lost\",1,0,");
  }
}
