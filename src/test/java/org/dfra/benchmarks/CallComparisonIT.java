package org.dfra.benchmarks;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.benchmarks.call.CallComparison;
import org.dfra.benchmarks.call.CallCondition;
import org.dfra.benchmarks.call.CallKind;
import org.dfra.benchmarks.call.CallMeasurement;
import org.dfra.benchmarks.call.CallPeer;
import org.dfra.benchmarks.call.CallResults;
import org.dfra.benchmarks.call.CallSettings;
import org.dfra.benchmarks.call.EchoServer;
import org.dfra.benchmarks.call.JitSetting;
import org.dfra.benchmarks.call.PeerProcesses;
import org.dfra.report.measurement.MeasuredValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The benchmark of calls between two processes, without its clock. */
@Timeout(300)
class CallComparisonIT {

  @TempDir private Path folder;

  /** The first condition that this computer can have. */
  private static CallCondition condition() throws Exception {
    for (CallCondition each : CallCondition.values()) {
      if (CallComparison.missing(each).isEmpty()) {
        return each;
      }
    }
    throw new AssertionError("there is always one: with the kernel's choice of cores");
  }

  /** Process IDs of this process's children, and of theirs. */
  private static Set<Long> children() {
    try (Stream<ProcessHandle> children = ProcessHandle.current().descendants()) {
      return children.map(ProcessHandle::pid).collect(Collectors.toSet());
    }
  }

  @ParameterizedTest
  @EnumSource
  void answersFromAnotherProcess(CallPeer peer) throws Exception {
    long own = ProcessHandle.current().pid();
    try (PeerProcesses processes =
        PeerProcesses.start(peer, CallComparison.cores(condition()), JitSetting.C1, folder)) {
      assertThat(List.of(processes.clientPid(), processes.serverPid()))
          .doesNotHaveDuplicates()
          .doesNotContain(own);
      assertThat(children()).contains(processes.clientPid(), processes.serverPid());
      for (long each : new long[] {0, -1, 361, Long.MIN_VALUE, Long.MAX_VALUE}) {
        assertThat(processes.echo(each)).isEqualTo(each);
      }
      assertThat(processes.values()).hasSize(361).isEqualTo(EchoServer.EXPECTED);
      assertThat(processes.values()).doesNotHaveDuplicates();
    }
  }

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes 10 s")
  void measuresAllPeersAndLeavesNoProcess() throws Exception {
    Set<Long> before = children();
    List<String> progress = new ArrayList<>();
    CallComparison comparison =
        new CallComparison(
            condition(), JitSetting.C1, List.of(CallPeer.values()), CallSettings.QUICK);

    CallResults results = comparison.run(progress::add);

    assertThat(progress).hasSize(1);
    for (CallPeer peer : CallPeer.values()) {
      for (CallKind kind : CallKind.values()) {
        List<CallMeasurement> measured = results.measurements(peer, kind);
        assertThat(measured).as(peer + ", " + kind).hasSize(1);
        assertThat(measured.get(0).times().calls())
            .as("checked answers: " + peer + ", " + kind)
            .isEqualTo(CallSettings.QUICK.calls(kind));
      }
      assertThat(results.table().lines()).anyMatch(line -> line.startsWith(peer.label() + " "));
    }
    assertThat(results.figures())
        .extracting(MeasuredValue::name)
        .contains(comparison.title() + ", dfra-tcp, 361 doubles, over rmi");
    assertThat(results.figures())
        .as("CPU time has the resolution of the kernel's clock tick")
        .filteredOn(each -> !each.name().endsWith("CPU time per call"))
        .allSatisfy(each -> assertThat(each.value()).as(each.name()).isFinite().isPositive());
    assertThat(results.figures())
        .allSatisfy(each -> assertThat(each.value()).as(each.name()).isFinite().isNotNegative());
    assertThat(children()).as("processes that still run").isEqualTo(before);
  }
}
