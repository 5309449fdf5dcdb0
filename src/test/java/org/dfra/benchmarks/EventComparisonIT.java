package org.dfra.benchmarks;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dfra.benchmarks.event.EventComparison;
import org.dfra.benchmarks.event.EventPeer;
import org.dfra.benchmarks.event.EventProcesses;
import org.dfra.benchmarks.event.EventSettings;
import org.dfra.benchmarks.event.EventTimes;
import org.dfra.report.measurement.MeasuredValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The benchmark of events between processes, without its clock. */
@Timeout(300)
class EventComparisonIT {

  @ParameterizedTest
  @EnumSource
  void everyEventReachesEveryProcessOnce(EventPeer peer) throws Exception {
    List<Long> pids;
    try (EventProcesses processes = EventProcesses.start(peer, 2)) {
      pids = processes.pids();
      assertThat(pids).hasSize(3).doesNotHaveDuplicates();
      processes.warmUp(5, Duration.ofMillis(50));
      EventTimes times = processes.measure(20, Duration.ofMillis(50));
      assertThat(times.lost()).isZero();
      assertThat(times.p50()).isPositive().isLessThanOrEqualTo(times.p99());
      assertThat(times.p99()).isLessThanOrEqualTo(times.longest());
    }
    assertThat(pids).noneMatch(pid -> ProcessHandle.of(pid).isPresent());
  }

  @Test
  void reportsTheRatioToTheBareProgram() throws Exception {
    EventComparison comparison = new EventComparison(EventSettings.QUICK);
    comparison.run(progress -> {});
    assertThat(comparison.figures())
        .filteredOn(each -> each.name().endsWith("dfra, p99 over tcp"))
        .singleElement()
        .satisfies(
            ratio -> {
              assertThat(ratio.value()).isPositive();
              assertThat(ratio.target()).isEqualTo(1.5);
            });
    assertThat(comparison.figures())
        .extracting(MeasuredValue::name)
        .allMatch(name -> name.startsWith("events to 3 processes at 10 Hz, "));
    assertThat(comparison.table().lines(132)).hasSizeGreaterThan(2);
  }
}
