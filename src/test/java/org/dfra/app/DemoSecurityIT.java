package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/** {@code ./dfra demo security}. */
@EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes minutes")
class DemoSecurityIT extends DemoPlay {

  @Test
  void theTeamSearchesAndNobodyDoesWhatHeMayNot() throws Exception {
    String output =
        play(
            "security",
            List.of(),
            "anna$ ./dfra security init field",
            "anna$ ./dfra security issue robot atrv1",
            "atrv1$ ./dfra security join atrv1.bundle",
            "From an empty folder to two robots that authenticate each other",
            "has received 3 positions of gps_front",
            "Otto drives: Effector.execute of drive is refused to observer otto of field",
            "Otto's argument was not even looked at",
            "A program that has joined no team sees",
            "It reads a position: GPSSensor.fix of gps_front is refused to a stranger",
            "It stops the robot: Effector.emergencyStop of drive is refused to a stranger",
            "entries that name robot atrv1 are refused",
            "The rogue receiver was called 0 times",
            "so it was altered",
            "Revoked operator oscar: 1 certificate",
            "Robot atrv2 has list 2 and policy 1 in force after",
            "Oscar's next call fails",
            "its search is paused (the certificate of the one who gave the goal was revoked)",
            "anna$ ./dfra task resume --robot=atrv2",
            "anna$ ./dfra security publish",
            "Robot atrv1 has list 2 and policy 2 in force after",
            "GPSSensor.fix of gps_front is refused to observer otto of field (127.0.0.1) by rule"
                + " no-positions",
            "atrv1: the region is searched: it has reached all waypoints.",
            "atrv2: the region is searched: it has reached all waypoints.",
            "The receiver was called 0 times; 0 modules were registered there.",
            "calls that a rogue receiver has received 0 target ≤ 0",
            "collisions 0 target ≤ 0");
    assertThat(output)
        .containsSubsequence(
            "atrv1$ ./dfra audit --who=otto", "atrv1$ ./dfra audit verify", "All ");
  }
}
