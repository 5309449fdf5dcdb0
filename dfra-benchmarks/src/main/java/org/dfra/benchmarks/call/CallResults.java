package org.dfra.benchmarks.call;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.dfra.benchmarks.call.CallMeasurement.ProcessUse;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.terminal.Table;

/**
 * The results of all peers under one condition. Each figure is the median over the repetitions. A
 * ratio is that to {@link CallPeer#REFERENCE} in the same repetition: the median of the
 * repetitions' ratios, and the lowest and highest of them. Not thread-safe.
 */
public final class CallResults {

  private final String title;

  private final Map<CallPeer, Map<CallKind, List<CallMeasurement>>> measured =
      new EnumMap<>(CallPeer.class);

  /**
   * @param title condition and JIT compilers, before the names of the figures
   */
  public CallResults(String title) {
    this.title = title;
  }

  /** Adds the measurement of a peer's next repetition. */
  public void add(CallPeer peer, CallKind kind, CallMeasurement measurement) {
    measured
        .computeIfAbsent(peer, each -> new EnumMap<>(CallKind.class))
        .computeIfAbsent(kind, each -> new ArrayList<>())
        .add(measurement);
  }

  /** The measurements of a peer so far, by repetition. */
  public List<CallMeasurement> measurements(CallPeer peer, CallKind kind) {
    return List.copyOf(measured.getOrDefault(peer, Map.of()).getOrDefault(kind, List.of()));
  }

  /**
   * Voluntary context switches of a process for a call.
   *
   * @param perCall the median of the repetitions that are complete; if there is none, of all
   * @param isComplete whether there is such a repetition; otherwise {@code perCall} is too low
   */
  private record Switches(double perCall, boolean isComplete) {

    static Switches of(List<ProcessUse> uses) {
      List<Double> complete =
          uses.stream().filter(ProcessUse::isComplete).map(ProcessUse::switchesPerCall).toList();
      List<Double> all = uses.stream().map(ProcessUse::switchesPerCall).toList();
      boolean isComplete = !complete.isEmpty();
      return new Switches(Spread.of(isComplete ? complete : all).median(), isComplete);
    }

    String text() {
      return (isComplete || Double.isNaN(perCall) ? "" : "≥ ") + Spread.text(perCall);
    }
  }

  private Switches switches(CallPeer peer, CallKind kind, Side side) {
    return Switches.of(measurements(peer, kind).stream().map(side::use).toList());
  }

  private Spread spread(CallPeer peer, CallKind kind, ToDoubleFunction<CallMeasurement> figure) {
    return Spread.of(values(peer, kind, figure));
  }

  private double median(CallPeer peer, CallKind kind, ToDoubleFunction<CallMeasurement> figure) {
    return spread(peer, kind, figure).median();
  }

  private List<Double> values(
      CallPeer peer, CallKind kind, ToDoubleFunction<CallMeasurement> figure) {
    List<CallMeasurement> found = measurements(peer, kind);
    if (found.isEmpty()) {
      throw new IllegalStateException(
          peer.label() + " has no result of " + kind.label() + ": " + title);
    }
    return found.stream().map(figure::applyAsDouble).toList();
  }

  private Spread ratio(CallPeer peer, CallKind kind, ToDoubleFunction<CallMeasurement> figure) {
    List<Double> own = values(peer, kind, figure);
    List<Double> reference = values(CallPeer.REFERENCE, kind, figure);
    if (own.size() != reference.size()) {
      throw new IllegalStateException(
          peer.label()
              + " has "
              + own.size()
              + " repetitions and "
              + CallPeer.REFERENCE.label()
              + " has "
              + reference.size()
              + ": "
              + title);
    }
    return Spread.ofRatios(own, reference);
  }

  /**
   * A row for each peer that was measured. Columns: p50 and p99 of a small call, µs; p50 of the
   * call with the larger result, µs; small calls per second by many threads at once; voluntary
   * context switches and CPU time, µs, for a small call, client + server; after what is compared,
   * its ratio to {@link CallPeer#REFERENCE}.
   */
  public Table table() {
    String over = "× " + CallPeer.REFERENCE.label();
    Table table =
        new Table(
            "peer",
            "small p50",
            "p99",
            over,
            EchoService.VALUES + " p50",
            over,
            CallKind.CALLERS.threads() + ": 1/s",
            over,
            "switches",
            "CPU");
    for (CallPeer peer : measured.keySet()) {
      table.row(
          peer.label(),
          Spread.text(median(peer, CallKind.SMALL, CallResults::p50)),
          Spread.text(median(peer, CallKind.SMALL, CallResults::p99)),
          ratio(peer, CallKind.SMALL, CallResults::p50).text(),
          Spread.text(median(peer, CallKind.VALUES, CallResults::p50)),
          ratio(peer, CallKind.VALUES, CallResults::p50).text(),
          Spread.text(median(peer, CallKind.CALLERS, CallResults::perSecond)),
          ratio(peer, CallKind.CALLERS, CallResults::perSecond).text(),
          switches(peer, CallKind.SMALL, CallMeasurement::client).text()
              + " + "
              + switches(peer, CallKind.SMALL, CallMeasurement::server).text(),
          Spread.text(median(peer, CallKind.SMALL, each -> each.client().cpuPerCall()))
              + " + "
              + Spread.text(median(peer, CallKind.SMALL, each -> each.server().cpuPerCall())));
    }
    return table;
  }

  private static double p50(CallMeasurement measurement) {
    return measurement.times().p50();
  }

  private static double p99(CallMeasurement measurement) {
    return measurement.times().p99();
  }

  private static double perSecond(CallMeasurement measurement) {
    return measurement.times().perSecond();
  }

  /** What is recorded, for each peer that was measured. */
  public List<MeasuredValue> figures() {
    List<MeasuredValue> figures = new ArrayList<>();
    for (CallPeer peer : measured.keySet()) {
      for (CallKind kind : CallKind.values()) {
        String name = title + ", " + peer.label() + ", " + kind.label() + ", ";
        ToDoubleFunction<CallMeasurement> compared;
        if (kind == CallKind.CALLERS) {
          compared = CallResults::perSecond;
          figures.add(figure(name + "rate", median(peer, kind, compared), "1/s"));
        } else {
          compared = CallResults::p50;
          figures.add(figure(name + "p50", median(peer, kind, compared), "µs"));
          figures.add(figure(name + "p99", median(peer, kind, CallResults::p99), "µs"));
        }
        if (peer != CallPeer.REFERENCE) {
          Spread ratio = ratio(peer, kind, compared);
          String over = name + "over " + CallPeer.REFERENCE.label();
          figures.add(figure(over, ratio.median(), "×"));
          figures.add(figure(over + ", lowest", ratio.low(), "×"));
          figures.add(figure(over + ", highest", ratio.high(), "×"));
        }
        addUse(figures, name + "client", peer, kind, CallMeasurement::client);
        addUse(figures, name + "server", peer, kind, CallMeasurement::server);
      }
    }
    return figures;
  }

  /** One of the two processes of a measurement. */
  @FunctionalInterface
  private interface Side {
    ProcessUse use(CallMeasurement measurement);
  }

  private void addUse(
      List<MeasuredValue> figures, String name, CallPeer peer, CallKind kind, Side side) {
    Switches switches = switches(peer, kind, side);
    if (!Double.isNaN(switches.perCall())) {
      figures.add(
          figure(
              name
                  + ", voluntary context switches per call"
                  + (switches.isComplete() ? "" : ", of threads that did not end"),
              switches.perCall(),
              ""));
    }
    figures.add(
        figure(
            name + ", CPU time per call",
            median(peer, kind, each -> side.use(each).cpuPerCall()),
            "µs"));
  }

  private static MeasuredValue figure(String what, double value, String unit) {
    return new MeasuredValue(what, value, Double.POSITIVE_INFINITY, unit);
  }
}
