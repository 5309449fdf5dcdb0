package org.dfra.benchmarks.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dfra.benchmarks.call.CallMeasurement.ProcessUse;
import org.dfra.report.measurement.MeasuredValue;
import org.junit.jupiter.api.Test;

class CallResultsTest {

  private static final ProcessUse CLIENT = new ProcessUse(2, true, 30);
  private static final ProcessUse SERVER = new ProcessUse(3, true, 40);

  private final CallResults results = new CallResults("one core, C1");

  private void add(CallPeer peer, double micros, ProcessUse server) {
    for (CallKind kind : CallKind.values()) {
      CallTimes times = new CallTimes(100, micros, 3 * micros, 1e6 / micros);
      results.add(peer, kind, new CallMeasurement(times, CLIENT, server));
    }
  }

  private double value(String name) {
    return results.figures().stream()
        .filter(each -> each.name().equals("one core, C1, " + name))
        .findFirst()
        .orElseThrow(
            () ->
                new AssertionError(
                    name
                        + " is not among "
                        + results.figures().stream().map(MeasuredValue::name).toList()))
        .value();
  }

  @Test
  void reportsMediansAndTheRatiosWithinEachRepetition() {
    double[] rmi = {50, 100, 60}; // the second repetition was disturbed, and both with it
    double[] dfra = {150, 310, 240};
    for (int i = 0; i < rmi.length; i++) {
      add(CallPeer.RMI, rmi[i], SERVER);
      add(CallPeer.DFRA_LOCAL, dfra[i], SERVER);
    }
    assertThat(value("rmi, small call, p50")).isEqualTo(60);
    assertThat(value("dfra-local, small call, p50")).isEqualTo(240);
    assertThat(value("dfra-local, small call, p99")).isEqualTo(720);
    assertThat(value("dfra-local, small call, over rmi")).isCloseTo(3.1, within(1e-9));
    assertThat(value("dfra-local, small call, over rmi, lowest")).isCloseTo(3, within(1e-9));
    assertThat(value("dfra-local, small call, over rmi, highest")).isCloseTo(4, within(1e-9));
    assertThat(value("dfra-local, 32 callers, rate")).isCloseTo(1e6 / 240, within(1e-6));
    assertThat(value("dfra-local, 32 callers, over rmi, lowest")).isCloseTo(0.25, within(1e-9));
    assertThat(value("dfra-local, small call, client, CPU time per call")).isEqualTo(30);
    assertThat(value("dfra-local, small call, server, CPU time per call")).isEqualTo(40);
    List<String> lines = results.table().lines();
    assertThat(lines).hasSize(3);
    assertThat(lines.get(1)).startsWith("rmi ").contains(" 1.00 ", "2.00 + 3.00", "30.0 + 40.0");
    assertThat(lines.get(2))
        .startsWith("dfra-local ")
        .contains("3.10 (3.00–4.00)", "0.32 (0.25–0.33)");
  }

  @Test
  void countsSwitchesWhereNoThreadEnded() {
    add(CallPeer.RMI, 50, new ProcessUse(1, false, 40));
    add(CallPeer.RMI, 50, new ProcessUse(5, true, 40));
    add(CallPeer.RMI, 50, new ProcessUse(7, true, 40));
    add(CallPeer.JERI, 50, new ProcessUse(4, false, 40));
    add(CallPeer.JERI, 50, new ProcessUse(4, false, 40));
    add(CallPeer.JERI, 50, new ProcessUse(4, false, 40));
    String switches = ", small call, server, voluntary context switches per call";
    assertThat(value("rmi" + switches)).isEqualTo(6);
    assertThat(value("jeri" + switches + ", of threads that did not end")).isEqualTo(4);
    List<String> lines = results.table().lines();
    assertThat(lines.get(1)).contains("2.00 + 6.00");
    assertThat(lines.get(2)).contains("2.00 + ≥ 4.00");
  }

  @Test
  void recordsNoSwitchesOfAComputerThatDoesNotCountThem() {
    add(CallPeer.RMI, 50, new ProcessUse(Double.NaN, true, 40));
    assertThat(results.figures())
        .extracting(MeasuredValue::name)
        .anyMatch(each -> each.contains("client, voluntary context switches"))
        .noneMatch(each -> each.contains("server, voluntary context switches"));
    assertThat(results.table().lines().get(1)).contains("2.00 + ?");
  }

  @Test
  void refusesAPeerWithoutTheReference() {
    add(CallPeer.DFRA_LOCAL, 50, SERVER);
    assertThatThrownBy(results::figures)
        .hasMessage("rmi has no result of small call: one core, C1");
  }
}
