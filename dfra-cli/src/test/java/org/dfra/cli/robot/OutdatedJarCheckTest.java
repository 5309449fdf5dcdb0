package org.dfra.cli.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OutdatedJarCheckTest {

  @TempDir Path proc;

  private boolean runsFromOther(String lib) throws IOException {
    Files.createDirectories(proc.resolve("42"));
    Files.writeString(
        proc.resolve("42/cmdline"), "java\0-cp\0/dfra/.dfra/jars/2/lib/dfra-cli.jar\0Group\0");
    return OutdatedJarCheck.runsFromOther(proc, 42, lib);
  }

  @Test
  void knowsAGroupThatWasStartedFromAnOlderBuild() throws IOException {
    assertThat(runsFromOther("/dfra/.dfra/jars/2/lib")).isFalse();
    assertThat(runsFromOther("/dfra/.dfra/jars/3/lib")).isTrue();
    assertThat(runsFromOther("/dfra/.dfra/jars/2/li")).isTrue();
  }

  @Test
  void claimsNothingOfAProcessThatItCannotSee() {
    assertThat(OutdatedJarCheck.runsFromOther(proc, 43, "/dfra/lib")).isFalse();
    assertThat(OutdatedJarCheck.runsFromOther(proc, -1, "/dfra/lib")).isFalse();
  }
}
