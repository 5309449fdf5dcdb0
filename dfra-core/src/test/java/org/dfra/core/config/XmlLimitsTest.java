package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

class XmlLimitsTest {

  @TempDir Path temp;

  /** Without the limit the parser needs minutes, and does not notice an interruption. */
  @Test
  @Timeout(value = 30, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void refusesElementsThatAreNestedDeeperThanAnyRobot() {
    RobotFolder folder = nested(200_000);

    assertThatThrownBy(folder::read)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("robot.xml:2")
        .hasMessageContaining("elements are nested deeper than 64");
  }

  @Test
  void judgesWhatIsNestedLessDeeplyByTheSchema() {
    RobotFolder folder = nested(60);

    assertThatThrownBy(folder::read)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("<group>");
  }

  @Test
  void refusesAFileThatIsLargerThanAnyRobots() {
    RobotFolder folder =
        new RobotFolder(temp)
            .document("<robot xmlns=\"urn:dfra:robot:1\" name=\"a\">" + " ".repeat(17 << 20));

    assertThatThrownBy(folder::read)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("at most 16777216 are read");
  }

  private RobotFolder nested(int depth) {
    return new RobotFolder(temp)
        .document(
            "<robot xmlns=\"urn:dfra:robot:1\" name=\"atrv1\">\n"
                + "<group name=\"g\">".repeat(depth)
                + "</group>".repeat(depth)
                + "\n</robot>\n");
  }
}
