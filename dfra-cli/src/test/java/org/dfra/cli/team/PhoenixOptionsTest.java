package org.dfra.cli.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** Which phoenix is meant where an option is not given. */
class PhoenixOptionsTest {

  /** A command with the options of {@code up}. */
  @Command(name = "begins")
  static final class Begins {

    @Mixin private PhoenixOptions options;
  }

  @TempDir Path state;

  private PhoenixProcess phoenix(String port) throws IOException {
    Begins begins = new Begins();
    CommandLine line = new CommandLine(begins);
    var unused =
        port.isEmpty()
            ? line.parseArgs("--state=" + state)
            : line.parseArgs("--state=" + state, "--registry-port=" + port);
    return begins.options.lastStarted();
  }

  /** Any user of the computer finds phoenix by it. */
  @Test
  void phoenixHasNoRegistryUnlessItsPortIsNamed() throws Exception {
    assertThat(phoenix("").registryPort()).isEqualTo(-1);
    assertThat(PhoenixOptions.lastStarted(state, PhoenixOptions.REGISTRY_PORT).registryPort())
        .as("where a command has no such option")
        .isEqualTo(-1);
    assertThat(phoenix("1098").registryPort()).isEqualTo(1098);
  }
}
