package org.dfra.examples.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.ModuleReadings.Fix;
import org.junit.jupiter.api.Test;

class ReceiverOutageTest {

  @Test
  void aReceiverThatWasKilledIsSilentUntilItIsBackAndTheOtherIsNot() {
    List<Fix> fixes = new ArrayList<>();
    for (int second = 0; second <= 86; second++) {
      fixes.add(new Fix(second + 0.1, "gps_front", 0, 0));
      if (second < 20 || second > 30) {
        fixes.add(new Fix(second + 0.2, "gps_rear", 0, 0));
      }
    }
    assertThat(ReceiverOutage.all(flight(fixes)))
        .containsExactly(new ReceiverOutage("gps_rear", 19.2, 31.2));
  }

  @Test
  void itIsSilentToTheEndWhereItDoesNotComeBack() {
    assertThat(ReceiverOutage.all(flight(List.of(new Fix(0.5, "gps_front", 0, 0)))))
        .containsExactly(new ReceiverOutage("gps_front", 0.5, 86));
  }

  private static RobotMissionResult flight(List<Fix> fixes) {
    return new RobotMissionResult(
        "atrv1",
        true,
        "it ends",
        HandMade.drive(HandMade.plan(), 0, 0, 8),
        Map.of(),
        new ModuleReadings(fixes, List.of(), List.of(), List.of()));
  }
}
