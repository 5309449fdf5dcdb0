package org.dfra.module;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.dfra.lifecycle.Readiness;
import org.junit.jupiter.api.Test;

class IdentificationTest {

  @Test
  void thePathIsRobotAndName() {
    assertThat(new Identification("atrv1", "gps", "a receiver", "DFRA", "1").path())
        .isEqualTo("atrv1/gps");
  }

  @Test
  void nothingMayBeBlank() {
    assertRefused("robot", "", "b", "c", "d", "e");
    assertRefused("name", "a", " ", "c", "d", "e");
    assertRefused("description", "a", "b", "\t", "d", "e");
    assertRefused("author", "a", "b", "c", "", "e");
    assertRefused("version", "a", "b", "c", "d", "");
  }

  private static void assertRefused(
      String what, String robot, String name, String description, String author, String version) {
    assertThatThrownBy(() -> new Identification(robot, name, description, author, version))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("a module's " + what + " is blank; give it at least one letter");
  }

  @Test
  void aModuleThatIsNotReadySaysItsStateAndWhatItWaitsFor() {
    NotReadyException complaint =
        new NotReadyException("atrv1/gps", Readiness.INITIALIZING, "no fix yet; waits for one");

    assertThat(complaint).hasMessage("atrv1/gps is INITIALIZING: no fix yet; waits for one");
    assertThat(complaint.readiness()).isEqualTo(Readiness.INITIALIZING);
  }
}
