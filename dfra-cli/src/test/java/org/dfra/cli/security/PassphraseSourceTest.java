package org.dfra.cli.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.nio.file.Files;
import java.nio.file.Path;
import org.dfra.report.terminal.CommandFailure;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Where passphrases are from. */
class PassphraseSourceTest {

  @TempDir Path folder;

  @Test
  void theFirstLineOfAFileIsThePassphrase() throws Exception {
    Path file = Files.writeString(folder.resolve("pass"), "  secret words \r\nmore\n");
    assertThat(PassphraseSource.read(file, "passphrase", "--f")).isEqualTo("secret words");
  }

  @Test
  void aFileWithoutOneIsNamed() throws Exception {
    Path file = folder.resolve("pass");
    assertThatThrownBy(() -> PassphraseSource.read(file, "passphrase", "--f"))
        .isInstanceOf(CommandFailure.class)
        .hasMessage("there is no file %s; name the one with the passphrase", file);
    Files.writeString(file, "\n");
    assertThatThrownBy(() -> PassphraseSource.read(file, "passphrase", "--f"))
        .hasMessage("%s is empty; its first line must be the passphrase", file);
    assertThatThrownBy(() -> PassphraseSource.read(folder, "passphrase", "--f"))
        .hasMessageStartingWith("the passphrase in " + folder + " cannot be read");
  }

  @Test
  void withoutATerminalAnOptionIsNamed() {
    assumeFalse(System.console() != null, "this test has a terminal");
    assertThatThrownBy(() -> PassphraseSource.read(null, "passphrase of a.bundle", "--f"))
        .isInstanceOf(CommandFailure.class)
        .hasMessage(
            "there is no terminal on which to ask for the passphrase of a.bundle; name a file with"
                + " --f");
  }
}
