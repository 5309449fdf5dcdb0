package org.dfra.benchmarks.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class CoresTest {

  private static final Cores FOUR =
      new Cores(List.of(2, 3, 6, 7), true, List.of("chrt", "-i", "0"));

  @Test
  void readsTheKernelsLists() {
    assertThat(Cores.parse("0-3,8,10-11")).containsExactly(0, 1, 2, 3, 8, 10, 11);
    assertThat(Cores.parse("5")).containsExactly(5);
  }

  @Test
  void findsThoseOfThisComputer() throws Exception {
    Cores cores = Cores.ofThisComputer();
    if (ProcessCounters.of(ProcessHandle.current().pid()).switches().isEmpty()) {
      assertThat(cores.canPin()).as("a computer without /proc").isFalse();
    } else {
      assertThat(cores.allowed()).hasSize(Runtime.getRuntime().availableProcessors());
    }
  }

  @Test
  void assignsOnlyCoresThatThisProcessMayUse() throws Exception {
    CoreAssignment one = CallCondition.ONE_CORE.assign(FOUR);
    assertThat(one.clientPrefix()).containsExactly("taskset", "-c", "2");
    assertThat(one.serverPrefix()).isEqualTo(one.clientPrefix());
    assertThat(one.busyPrefixes()).isEmpty();
    CoreAssignment idle = CallCondition.IDLE_CORES.assign(FOUR);
    assertThat(idle.clientPrefix()).containsExactly("taskset", "-c", "2");
    assertThat(idle.serverPrefix()).containsExactly("taskset", "-c", "3");
    assertThat(idle.busyPrefixes()).isEmpty();
    CoreAssignment awake = CallCondition.AWAKE_CORES.assign(FOUR);
    assertThat(awake.clientPrefix()).isEqualTo(idle.clientPrefix());
    assertThat(awake.serverPrefix()).isEqualTo(idle.serverPrefix());
    assertThat(awake.busyPrefixes())
        .containsExactly(
            List.of("chrt", "-i", "0", "taskset", "-c", "2"),
            List.of("chrt", "-i", "0", "taskset", "-c", "3"));
  }

  @Test
  void namesWhatAConditionNeeds() throws Exception {
    Cores single = new Cores(List.of(0), true, List.of("nice", "-n", "19"));
    assertThat(CallCondition.ONE_CORE.assign(single).client()).isZero();
    assertThatThrownBy(() -> CallCondition.IDLE_CORES.assign(single))
        .hasMessageContaining("2 cores, and this process may use only 1");
    Cores noPriority = new Cores(List.of(0, 1), true, List.of());
    assertThat(CallCondition.IDLE_CORES.assign(noPriority).server()).isEqualTo(1);
    assertThatThrownBy(() -> CallCondition.AWAKE_CORES.assign(noPriority))
        .hasMessageContaining("chrt or nice");
    Cores noTaskset = new Cores(List.of(0, 1), false, List.of());
    assertThatThrownBy(() -> CallCondition.ONE_CORE.assign(noTaskset))
        .hasMessageContaining("taskset");
    assertThat(CallCondition.NOT_PINNED.assign(noTaskset).clientPrefix()).isEmpty();
    assertThatThrownBy(() -> CallCondition.NOT_PINNED.assign(FOUR))
        .hasMessageContaining("cannot pin");
  }
}
