package org.dfra.benchmarks.event;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.dfra.benchmarks.call.Spread;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.terminal.Table;

/**
 * Compares the latency of events: in each repetition each peer once, each time in new processes.
 * The first peer of a repetition is another one than that of the repetition before. Not
 * thread-safe.
 */
public final class EventComparison {

  /** The requirement for the 99th percentile, over that of the bare TCP program. */
  private static final double MOST = 1.5;

  private final EventSettings settings;
  private final Map<EventPeer, List<EventTimes>> measured = new EnumMap<>(EventPeer.class);

  /**
   * @param settings how much is measured
   */
  public EventComparison(EventSettings settings) {
    this.settings = settings;
    for (EventPeer each : EventPeer.values()) {
      measured.put(each, new ArrayList<>());
    }
  }

  /**
   * Measures.
   *
   * @param progress is notified of each repetition
   * @throws IOException if a process does not start, or an event does not arrive
   */
  public void run(Consumer<String> progress) throws IOException, InterruptedException {
    for (int i = 0; i < settings.repetitions(); i++) {
      List<EventPeer> order = new ArrayList<>(List.of(EventPeer.values()));
      Collections.rotate(order, -i);
      progress.accept(
          "Events: repetition "
              + (i + 1)
              + " of "
              + settings.repetitions()
              + ", "
              + String.join(", ", order.stream().map(EventPeer::label).toList())
              + " …");
      for (EventPeer peer : order) {
        try (EventProcesses processes = EventProcesses.start(peer, settings.listeners())) {
          processes.warmUp(settings.warmUp(), settings.warmUpPeriod());
          add(peer, processes.measure(settings.events(), settings.period()));
        }
      }
    }
  }

  /** Adds the measurement of a peer's next repetition. */
  void add(EventPeer peer, EventTimes times) {
    times(peer).add(times);
  }

  private List<EventTimes> times(EventPeer peer) {
    return measured.getOrDefault(peer, List.of());
  }

  private List<Double> values(EventPeer peer, ToDoubleFunction<EventTimes> figure) {
    return times(peer).stream().map(figure::applyAsDouble).toList();
  }

  private Spread spread(EventPeer peer, ToDoubleFunction<EventTimes> figure) {
    return Spread.of(values(peer, figure));
  }

  private Spread ratio(EventPeer peer, ToDoubleFunction<EventTimes> figure) {
    return Spread.ofRatios(values(peer, figure), values(EventPeer.REFERENCE, figure));
  }

  /** A row for each peer: medians of the repetitions, and ratios with their lowest and highest. */
  public Table table() {
    String over = "× " + EventPeer.REFERENCE.label();
    Table table = new Table("peer", "p50, ms", over, "p99, ms", over, "longest", "CPU, µs", "lost");
    for (EventPeer peer : EventPeer.values()) {
      table.row(
          peer.label(),
          spread(peer, EventTimes::p50).text(),
          ratio(peer, EventTimes::p50).text(),
          spread(peer, EventTimes::p99).text(),
          ratio(peer, EventTimes::p99).text(),
          spread(peer, EventTimes::longest).text(),
          spread(peer, EventTimes::cpu).text(),
          Integer.toString(times(peer).stream().mapToInt(EventTimes::lost).sum()));
    }
    return table;
  }

  /** What is recorded. */
  public List<MeasuredValue> figures() {
    List<MeasuredValue> figures = new ArrayList<>();
    String title =
        "events to "
            + settings.listeners()
            + " processes at "
            + Math.round(1000.0 / settings.period().toMillis())
            + " Hz, ";
    for (EventPeer peer : EventPeer.values()) {
      String name = title + peer.label() + ", ";
      figures.add(figure(name + "p50", spread(peer, EventTimes::p50).median(), "ms"));
      figures.add(figure(name + "p99", spread(peer, EventTimes::p99).median(), "ms"));
      figures.add(figure(name + "longest", spread(peer, EventTimes::longest).median(), "ms"));
      figures.add(
          figure(name + "CPU time per delivery", spread(peer, EventTimes::cpu).median(), "µs"));
      figures.add(
          figure(
              name + "events lost in all repetitions",
              times(peer).stream().mapToInt(EventTimes::lost).sum(),
              ""));
    }
    String over = " over " + EventPeer.REFERENCE.label();
    for (EventPeer peer : EventPeer.values()) {
      if (peer != EventPeer.REFERENCE) {
        String name = title + peer.label() + ", ";
        addRatio(figures, name + "p50" + over, ratio(peer, EventTimes::p50), Double.NaN);
        addRatio(figures, name + "p99" + over, ratio(peer, EventTimes::p99), MOST);
      }
    }
    return figures;
  }

  private static void addRatio(
      List<MeasuredValue> figures, String name, Spread ratio, double most) {
    figures.add(
        new MeasuredValue(
            name, ratio.median(), Double.isNaN(most) ? Double.POSITIVE_INFINITY : most, "×"));
    figures.add(figure(name + ", lowest", ratio.low(), "×"));
    figures.add(figure(name + ", highest", ratio.high(), "×"));
  }

  private static MeasuredValue figure(String what, double value, String unit) {
    return new MeasuredValue(what, value, Double.POSITIVE_INFINITY, unit);
  }

  /** What is compared, a line for each peer. */
  public static List<String> descriptions() {
    return Arrays.stream(EventPeer.values())
        .map(each -> "  " + each.label() + ": " + each.description() + ".")
        .toList();
  }
}
