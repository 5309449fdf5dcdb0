package org.dfra.benchmarks.micro;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.terminal.Table;

/**
 * The results of some benchmarks: a median and a 99th percentile for each round, of which the
 * median over the rounds is reported. A ratio is the median of the rounds' ratios. Not thread-safe.
 */
public final class MicroResults {

  private final List<MicroBenchmark> chosen;
  private final Map<String, List<RoundResult>> rounds = new HashMap<>(); // by ID

  /** Of these benchmarks. */
  public MicroResults(List<MicroBenchmark> chosen) {
    this.chosen = List.copyOf(chosen);
  }

  /** Microseconds. */
  private record RoundResult(double median, double p99) {}

  /**
   * Adds a benchmark's next round.
   *
   * @param id of the benchmark
   * @param median of an operation's time, microseconds
   * @param p99 99th percentile of that, microseconds
   */
  public void add(String id, double median, double p99) {
    rounds.computeIfAbsent(id, key -> new ArrayList<>()).add(new RoundResult(median, p99));
  }

  /**
   * What is recorded: of each benchmark the median, the 99th percentile and how much the rounds
   * differ; of compared ones also the ratio of the medians.
   *
   * @throws IllegalStateException if a benchmark has no result
   */
  public List<MeasuredValue> figures() {
    List<MeasuredValue> figures = new ArrayList<>();
    for (MicroBenchmark each : chosen) {
      String title = each.title();
      figures.add(figure(title + ", median", shown(each, median(medians(each))), unit(each)));
      figures.add(figure(title + ", p99", shown(each, median(p99s(each))), unit(each)));
      if (medians(each).size() > 1) {
        double spread = Collections.max(medians(each)) / Collections.min(medians(each));
        figures.add(figure(title + ", slowest round over fastest", spread, "×"));
      }
      List<Double> ratios = ratios(each);
      if (!ratios.isEmpty()) {
        figures.add(figure(each.operation() + ", over " + variant(each), median(ratios), "×"));
      }
    }
    return figures;
  }

  private static MeasuredValue figure(String what, double value, String unit) {
    return new MeasuredValue(what, value, Double.POSITIVE_INFINITY, unit);
  }

  /** The same for people: a row for each benchmark. */
  public Table table() {
    Table table = new Table("operation", "median", "p99", "medians of rounds", "compared");
    for (MicroBenchmark each : chosen) {
      DoubleUnaryOperator shown = micros -> shown(each, micros);
      List<Double> ratios = ratios(each);
      table.row(
          each.title(),
          text(shown.applyAsDouble(median(medians(each)))) + " " + unit(each),
          text(shown.applyAsDouble(median(p99s(each)))) + " " + unit(each),
          medians(each).size() == 1
              ? ""
              : range(medians(each).stream().map(shown::applyAsDouble).toList()),
          ratios.isEmpty()
              ? ""
              : text(median(ratios))
                  + " × "
                  + variant(each)
                  + (ratios.size() > 1 ? " (" + range(ratios) + ")" : ""));
    }
    return table;
  }

  private static String variant(MicroBenchmark benchmark) {
    return benchmark.peer().orElseThrow().variant();
  }

  private List<RoundResult> of(MicroBenchmark benchmark) {
    List<RoundResult> found = rounds.getOrDefault(benchmark.id(), List.of());
    if (found.isEmpty()) {
      throw new IllegalStateException(benchmark.id() + " has no result");
    }
    return found;
  }

  private List<Double> medians(MicroBenchmark benchmark) {
    return of(benchmark).stream().map(RoundResult::median).toList();
  }

  private List<Double> p99s(MicroBenchmark benchmark) {
    return of(benchmark).stream().map(RoundResult::p99).toList();
  }

  /** Its median over that of its peer, for each round; empty if there is no peer among these. */
  private List<Double> ratios(MicroBenchmark benchmark) {
    List<Double> ratios = new ArrayList<>();
    benchmark
        .peer()
        .filter(chosen::contains)
        .ifPresent(
            peer -> {
              List<Double> own = medians(benchmark);
              List<Double> other = medians(peer);
              for (int i = 0; i < Math.min(own.size(), other.size()); i++) {
                ratios.add(own.get(i) / other.get(i));
              }
            });
    return ratios;
  }

  /** Microseconds, or megabytes in a second: the 99th percentile is a low throughput then. */
  private static double shown(MicroBenchmark benchmark, double micros) {
    int bytes = benchmark.bytes().getAsInt();
    return bytes == 0 ? micros : bytes / micros;
  }

  private static String unit(MicroBenchmark benchmark) {
    return benchmark.bytes().getAsInt() == 0 ? "µs" : "MB/s";
  }

  private static double median(List<Double> values) {
    List<Double> sorted = values.stream().sorted().toList();
    int middle = sorted.size() / 2;
    return sorted.size() % 2 == 1
        ? sorted.get(middle)
        : (sorted.get(middle - 1) + sorted.get(middle)) / 2;
  }

  private static String range(List<Double> values) {
    String low = text(Collections.min(values));
    String high = text(Collections.max(values));
    return low.equals(high) ? low : low + " to " + high;
  }

  /** Three digits, as far as they are decimals. */
  private static String text(double value) {
    int decimals = value >= 100 ? 0 : value >= 10 ? 1 : 2;
    return String.format(Locale.ROOT, "%." + decimals + "f", value);
  }
}
