package org.dfra.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.InstantSource;
import org.dfra.core.config.ConfigurationException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class RobotTimeTest {

  @AfterEach
  void forget() {
    System.clearProperty(RobotTime.PROPERTY);
  }

  @Test
  void isRealWhereNothingElseIsSaid() {
    System.setProperty(RobotTime.PROPERTY, "real");

    assertThat(RobotTime.clock()).isEqualTo(InstantSource.system());
    assertThat(RobotTime.options()).isEmpty();
  }

  @Test
  void isOneForAllModulesOfAVirtualMachine() {
    System.setProperty(RobotTime.PROPERTY, "4x since 2026-11-21T16:00:00Z");

    assertThat(RobotTime.clock()).isInstanceOf(ScaledTime.class).isSameAs(RobotTime.clock());
    assertThat(RobotTime.options()).containsExactly("-Ddfra.time=4x since 2026-11-21T16:00:00Z");
  }

  @Test
  void refusesWhatIsNoTime() {
    System.setProperty(RobotTime.PROPERTY, "fast");

    assertThatThrownBy(RobotTime::clock)
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "DFRA_TIME (or -Ddfra.time): \"fast\" is not a time; write it like 4x since"
                + " 2026-11-21T16:00:00Z, or write real");
  }
}
