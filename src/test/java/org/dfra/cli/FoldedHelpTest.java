package org.dfra.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;

/** What {@code --help} prints fits the terminal, and its footers read as they were written. */
class FoldedHelpTest {

  private static List<CommandLine> all(CommandLine line) {
    List<CommandLine> all = new ArrayList<>(List.of(line));
    line.getSubcommands().values().forEach(each -> all.addAll(all(each)));
    return all;
  }

  @Test
  void noHelpIsWiderThanAUsualTerminalOrLeavesAWordAlone() {
    for (CommandLine each : all(Main.commandLine())) {
      String help = each.getUsageMessage(Ansi.OFF);
      assertThat(help.lines()).as(help).allMatch(line -> line.length() <= 80);
      String footer = help.substring(Math.max(0, help.lastIndexOf("--version")));
      assertThat(footer.lines())
          .as("a line that picocli broke, of " + each.getCommandSpec().qualifiedName())
          .doesNotContain("that runs", "a report", "failures", "minute)");
    }
  }

  @Test
  void linesOfAParagraphAreFoldedTogether() {
    List<String> footer =
        List.of("", "One two three four", "five six.", "", "Seven:", "  a  eight");
    assertThat(FoldedHelp.folded(footer, 20))
        .containsExactly("", "One two three four", "five six.", "", "Seven:", "  a  eight");
    assertThat(FoldedHelp.folded(footer, 16))
        .containsExactly("", "One two three", "four five six.", "", "Seven:", "  a  eight");
  }

  @Test
  void anEntryOfAListGoesOnBelowItsExplanation() {
    List<String> list =
        List.of("Benchmarks:", "  mines   how often the detector is right, in a minute");
    assertThat(FoldedHelp.folded(list, 40))
        .containsExactly(
            "Benchmarks:", "  mines   how often the detector is", "          right, in a minute");
  }

  @Test
  void helpIsNeverNarrowerThanCanBeDrawn() {
    assertThat(FoldedHelp.width(20)).isEqualTo(55);
    assertThat(FoldedHelp.width(60)).isEqualTo(60);
    assertThat(FoldedHelp.width(200)).isEqualTo(80);
  }
}
