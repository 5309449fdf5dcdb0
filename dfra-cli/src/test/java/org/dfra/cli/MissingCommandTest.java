package org.dfra.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.dfra.report.terminal.ExitCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/** The verbs of a robot, which has this module and those below it. */
class MissingCommandTest {

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... args) {
    CommandLine line = Main.commandLine(args);
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    return line.execute(args);
  }

  @ParameterizedTest
  @CsvSource({
    "demo, demo, dfra-examples",
    "demo raster --speed=2, demo, dfra-examples",
    "demo --help, demo, dfra-examples",
    "help demo, demo, dfra-examples",
    "sim run world.xml, sim, dfra-examples",
    "fuzzy show drive.fis, fuzzy, dfra-examples",
    "security init field, security init, dfra-authority",
    "security issue robot atrv1, security issue, dfra-authority",
    "security revoke atrv1, security revoke, dfra-authority",
    "help security renew, security renew, dfra-authority",
    "bench calls, bench, dfra-benchmarks",
    "recruit experiment --seeds=2, recruit experiment, dfra-experiments",
    "help recruit experiment, recruit experiment, dfra-experiments",
  })
  void aVerbOfAModuleThatIsNotInstalledNamesTheModule(String typed, String verb, String module) {
    assertThat(run(typed.split(" "))).isEqualTo(ExitCode.NOT_INSTALLED).isEqualTo(69);
    assertThat(err.toString())
        .isEqualTo("dfra: " + verb + " is in " + module + ", which is not installed\n");
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void whatIsNotInstalledIsNotOffered() {
    assertThat(Main.commandLine().getSubcommands())
        .containsKeys("up", "stop", "recruit", "help")
        .doesNotContainKeys("demo", "sim", "bench", "fuzzy");
    assertThat(run("recruit")).isEqualTo(ExitCode.USAGE_ERROR);
    assertThat(err.toString()).isEqualTo("dfra: recruit needs a verb; there is resume, status\n");
  }

  @Test
  void aWordThatIsNoVerbAnywhereIsAUsageError() {
    assertThat(run("demonstrate")).isEqualTo(ExitCode.USAGE_ERROR);
    assertThat(err.toString()).startsWith("dfra: there is no verb \"demonstrate\"");
  }
}
