package org.dfra.report.measurement;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** How measured values are printed and stored. */
class RunMeasurementsTest {

  @TempDir Path folder;

  private static RunMeasurements three() {
    RunMeasurements figures = new RunMeasurements();
    figures.add(new MeasuredValue("met", 0.5, 3, "s"));
    figures.add(new MeasuredValue("missed", 4.0625, 3, "s"));
    figures.add(new MeasuredValue("stated", 20, Double.POSITIVE_INFINITY, "B/s"));
    return figures;
  }

  @Test
  void aLineShowsTheTargetAndWhetherItIsMissed() {
    assertThat(three().all().stream().map(each -> each.line().strip().replaceAll(" +", " ")))
        .containsExactly(
            "met 0.500 s target ≤ 3 s", "missed 4.063 s target ≤ 3 s MISSED", "stated 20 B/s");
  }

  @Test
  void linesStandInColumns() {
    List<String> lines = three().all().stream().map(MeasuredValue::line).toList();
    assertThat(lines.get(0).indexOf("target"))
        .isPositive()
        .isEqualTo(lines.get(1).indexOf("target"));
  }

  @Test
  void onlyABoundedFigureIsMissed() {
    assertThat(three().missed()).extracting(MeasuredValue::name).containsExactly("missed");
  }

  @Test
  void aFileIsBegunOnceAndThenContinued() throws Exception {
    Path file = folder.resolve("figures.csv");
    three().append(file, "demo", "first");
    three().append(file, "demo", "second");
    assertThat(Files.readAllLines(file))
        .hasSize(7)
        .startsWith("when,demo,java,cores,load,figure,measured,target_max,unit")
        .anyMatch(row -> row.contains(",first,") && row.endsWith(",\"missed\",4.0625,3,s"))
        .anyMatch(row -> row.contains(",second,") && row.endsWith(",\"stated\",20,,B/s"));
  }

  @Test
  void aLineFitsEightyColumnsAndItsNameIsFoldedByWord() {
    MeasuredValue longest =
        new MeasuredValue(
            "cold start of both robots to all modules working and shown", 1234.567, 16, "s");
    List<String> lines = longest.lines(80);
    assertThat(lines).hasSize(2).allMatch(line -> line.length() <= 80);
    assertThat(String.join(" ", lines).strip().replaceAll(" +", " "))
        .isEqualTo(
            "cold start of both robots to all modules working and shown 1235 s target ≤ 16 s"
                + " MISSED");
    assertThat(longest.lines(200)).hasSize(1);
  }

  @Test
  void aTimeIsNotWhatMustBeTrueButTheTimeInWhichARobotStopsIs() {
    RunMeasurements figures = new RunMeasurements();
    figures.add(new MeasuredValue("late", 7.3, 5, "s"));
    figures.add(new MeasuredValue("seconds in which two helped at once", 28, 0, "s"));
    figures.add(new MeasuredValue("collisions", 1, 0, ""));
    figures.add(new MeasuredValue("to standing", 0.6, 0.5, "s").asRequired());
    assertThat(figures.missedTimes()).extracting(MeasuredValue::name).containsExactly("late");
    assertThat(figures.failedRequirements())
        .extracting(MeasuredValue::name)
        .containsExactly("seconds in which two helped at once", "collisions", "to standing");
  }
}
