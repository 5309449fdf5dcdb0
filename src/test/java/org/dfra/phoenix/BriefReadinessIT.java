package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import org.dfra.river.phoenix.GroupStatus;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What was ready for a moment, failed and crashed later is no module that had worked. */
@Timeout(240)
class BriefReadinessIT {

  /** Times that one ends; the limit of restarts is 2. */
  private static final int ENDS = Boolean.getBoolean("dfra.full") ? 3 : 2;

  @TempDir static Path folder;

  private static PhoenixFixture phoenix;

  @BeforeAll
  static void start() throws Exception {
    phoenix =
        new PhoenixFixture(
                folder,
                "restartMinReady=500L",
                "restartLimit=2",
                "restartDelay=50L",
                "restartHoldOff=60000L",
                "restartWindow=60000L")
            .start();
  }

  @AfterAll
  static void end() {
    phoenix.close();
  }

  /** What is restarted for ever would go on beside the next test. */
  @AfterEach
  void forgetGroups() throws Exception {
    phoenix.clear();
  }

  private void activate(String group, String mode) throws Exception {
    ActivationGroupID id = phoenix.group(group);
    ActivationID beacon = phoenix.register(id, mode, true);
    assertThat(beacon.activate(false)).isNotNull();
  }

  @Test
  void oneThatWasReadyForAMomentIsHeldOffWhenItCrashesAgainAndAgain() throws Exception {
    activate("flash", "brief");
    GroupStatus heldOff =
        phoenix.awaitStatus(
            "flash", status -> status.heldOffUntil() != null || status.totalCrashes() > ENDS);
    assertThat(heldOff.totalCrashes()).isEqualTo(2);
    assertThat(heldOff.heldOffUntil()).isNotNull();
  }

  @Test
  void oneThatWasReadyUntilItsCrashIsRestartedHoweverOften() throws Exception {
    activate("lamp", "steady");
    GroupStatus crashed = phoenix.awaitStatus("lamp", status -> status.totalCrashes() > ENDS);
    assertThat(crashed.heldOffUntil()).isNull();
  }

  @Test
  void oneThatSomebodyEndsIsStartedAgainAndIsNotHeldOff() throws Exception {
    activate("lantern", "");
    for (int i = 0; i < ENDS; i++) {
      GroupStatus before = phoenix.awaitStatus("lantern", status -> status.pid() >= 0);
      assertThat(ProcessHandle.of(before.pid()).orElseThrow().destroy()).isTrue();
      GroupStatus again =
          phoenix.awaitStatus(
              "lantern",
              status ->
                  status.heldOffUntil() != null
                      || status.pid() >= 0 && status.incarnation() > before.incarnation());
      assertThat(again.heldOffUntil()).isNull();
    }
    assertThat(phoenix.status("lantern").totalCrashes()).isZero();
  }
}
