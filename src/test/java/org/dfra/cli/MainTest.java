package org.dfra.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;

/** A user who names a verb gets a command line with that alone, and sees no difference. */
class MainTest {

  static Stream<String> verbs() {
    return Main.commandLine().getSubcommands().keySet().stream();
  }

  @ParameterizedTest
  @MethodSource("verbs")
  void aVerbByItselfIsTheSameAsAmongOthers(String verb) {
    CommandLine among = Main.commandLine().getSubcommands().get(verb);
    CommandLine alone = Main.commandLine(new String[] {verb}).getSubcommands().get(verb);
    assertSame(among, alone);
  }

  private static void assertSame(CommandLine one, CommandLine other) {
    assertThat(other.getUsageMessage()).isEqualTo(one.getUsageMessage());
    assertThat(other.getCommandSpec().version()).isEqualTo(one.getCommandSpec().version());
    assertThat(other.isCaseInsensitiveEnumValuesAllowed())
        .isEqualTo(one.isCaseInsensitiveEnumValuesAllowed());
    assertThat(other.getSubcommands().keySet()).isEqualTo(one.getSubcommands().keySet());
    one.getSubcommands()
        .forEach((verb, each) -> assertSame(each, other.getSubcommands().get(verb)));
  }

  @Test
  void onlyWhatWasNamedIsRead() {
    assertThat(Main.commandLine(new String[] {"stop"}).getSubcommands()).containsOnlyKeys("stop");
    assertThat(Main.commandLine(new String[] {"help", "stop"}).getSubcommands())
        .containsKeys("stop", "module", "demo");
    assertThat(Main.commandLine(new String[] {"sotp"}).getSubcommands()).containsKey("stop");
    assertThat(Main.commandLine(new String[0]).getSubcommands()).containsKey("stop");
  }
}
