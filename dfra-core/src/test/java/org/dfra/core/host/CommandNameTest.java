package org.dfra.core.host;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Hints on what to type must work when they are copied. */
class CommandNameTest {

  @AfterEach
  void aCheckoutAgain() {
    System.clearProperty("dfra.command");
  }

  @Test
  void inACheckoutTheScriptIsNamedByItsPath() {
    assertThat(CommandName.current()).isEqualTo("./dfra");
    assertThat(CommandName.isInstalled()).isFalse();
    assertThat(CommandName.options()).isEmpty();
  }

  @Test
  void anInstallationAndTheRobotsItStartsUseTheNameOfTheInstalledCommand() {
    System.setProperty("dfra.command", "dfra");
    assertThat(CommandName.current()).isEqualTo("dfra");
    assertThat(CommandName.isInstalled()).isTrue();
    assertThat(CommandName.options()).containsExactly("-Ddfra.command=dfra");
  }
}
