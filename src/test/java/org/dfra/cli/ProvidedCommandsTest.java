package org.dfra.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** The verbs of other modules, where all modules are installed. */
class ProvidedCommandsTest {

  private static final ProvidedCommands ALL = ProvidedCommands.installed();

  @Test
  void whatIsKnownIsProvidedAndNothingElse() {
    assertThat(ALL.words()).containsExactlyInAnyOrderElementsOf(ProvidedCommands.known());
  }

  /** A resource that lies in another module's jar would make the message about it wrong. */
  @Test
  void theModuleThatIsSaidToHaveACommandHasIt() {
    for (String words : ProvidedCommands.known()) {
      assertThat(ALL.place(words))
          .as("the resource that names %s", words)
          .contains("/" + ProvidedCommands.module(words) + "/");
    }
  }

  @Test
  void nothingIsMissing() {
    for (String words : ProvidedCommands.known()) {
      assertThat(ALL.missing(words.split(" "))).isEmpty();
      assertThat(ALL.find(words)).isPresent();
    }
  }
}
