package org.dfra.benchmarks.micro;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.regex.Pattern;
import org.dfra.report.measurement.MeasuredValue;
import org.junit.jupiter.api.Test;

class MicroResultsTest {

  private static List<MicroBenchmark> matching(String pattern) {
    return MicroBenchmark.matching(Pattern.compile(pattern));
  }

  private static double value(MicroResults results, String name) {
    return results.figures().stream()
        .filter(each -> each.name().equals(name))
        .findFirst()
        .orElseThrow(() -> new AssertionError(name + " is not in " + results.figures()))
        .value();
  }

  @Test
  void reportsMediansOverRoundsAndTheMedianOfTheirRatios() {
    MicroResults results = new MicroResults(matching("returns a number"));
    double[] own = {300, 330, 600}; // the third round was disturbed, and both with it
    double[] plain = {150, 150, 300};
    for (int i = 0; i < 3; i++) {
      results.add("CallBenchmark.range", own[i], 2 * own[i]);
      results.add("CallBenchmark.rangePlain", plain[i], 2 * plain[i]);
    }
    assertThat(value(results, "call that returns a number, median")).isEqualTo(330);
    assertThat(value(results, "call that returns a number, p99")).isEqualTo(660);
    assertThat(value(results, "call that returns a number, slowest round over fastest"))
        .isEqualTo(2);
    assertThat(value(results, "call that returns a number, plain Java RMI, median")).isEqualTo(150);
    assertThat(value(results, "call that returns a number, over plain Java RMI")).isEqualTo(2);
    assertThat(results.figures()).extracting(MeasuredValue::unit).contains("µs", "×");
    List<String> lines = results.table().lines();
    assertThat(lines).hasSize(3);
    assertThat(lines.get(1))
        .contains("330 µs", "660 µs", "300 to 600", "2.00 × plain Java RMI (2.00 to 2.20)");
  }

  @Test
  void reportsAParsersBytesInASecond() {
    MicroResults results = new MicroResults(matching("NMEA"));
    int bytes = DeviceRecording.nmea().length;
    results.add("ParserBenchmark.nmea", bytes / 200.0, bytes / 100.0);
    assertThat(value(results, "parse NMEA 0183, median")).isCloseTo(200, within(1e-9));
    assertThat(value(results, "parse NMEA 0183, p99")).isCloseTo(100, within(1e-9));
    assertThat(results.figures())
        .as("one round differs from none, and there is nothing to compare it with")
        .hasSize(2)
        .extracting(MeasuredValue::unit)
        .containsOnly("MB/s");
  }

  @Test
  void comparesNothingThatDidNotRun() {
    MicroResults results = new MicroResults(matching("^CallBenchmark.scan$"));
    results.add("CallBenchmark.scan", 400, 700);
    assertThat(results.figures()).hasSize(2);
    assertThat(results.table().lines().get(1)).doesNotContain("×");
    assertThatThrownBy(() -> new MicroResults(matching("NMEA")).figures())
        .hasMessage("ParserBenchmark.nmea has no result");
  }
}
