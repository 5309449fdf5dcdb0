package org.dfra.docs;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.cli.team.PhoenixOptions;
import org.dfra.cli.team.TeamOptions;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** The part of {@code docs/reference/command-line.md} that the commands themselves print. */
final class CommandReference {

  private static final int WIDE = 400;

  /** Groups of options that many commands share, each by the heading under which it is listed. */
  private static final Map<String, Set<String>> SHARED =
      Map.of(
          "Where to look for robots", names(new TeamOptions()),
          "Where phoenix is", names(new PhoenixOptions()));

  private final StringBuilder text = new StringBuilder();

  private CommandReference() {}

  /** Markdown, a section for each verb and each verb of a verb. */
  static String of(CommandLine line) {
    CommandReference reference = new CommandReference();
    reference.shared("Where to look for robots", new TeamOptions());
    reference.shared("Where phoenix is", new PhoenixOptions());
    line.getSubcommands().values().forEach(verb -> reference.verb(verb, "##"));
    return reference.text.toString().strip() + "\n";
  }

  private static Set<String> names(Object mixin) {
    return CommandSpec.forAnnotatedObject(mixin).options().stream()
        .map(OptionSpec::longestName)
        .collect(Collectors.toSet());
  }

  private void shared(String heading, Object mixin) {
    section("##", heading);
    options(CommandSpec.forAnnotatedObject(mixin).options());
  }

  private void verb(CommandLine verb, String depth) {
    CommandSpec spec = verb.getCommandSpec();
    section(depth, "`./" + spec.qualifiedName(" ") + "`");
    paragraph(String.join(" ", spec.usageMessage().description()));
    if (verb.getSubcommands().isEmpty()) {
      paragraph("    ./" + synopsis(verb));
      List<OptionSpec> own = new ArrayList<>(spec.options());
      Set<String> names = own.stream().map(OptionSpec::longestName).collect(Collectors.toSet());
      Set<String> reported = new HashSet<>(Set.of("--help", "--version"));
      List<String> links = new ArrayList<>();
      SHARED.forEach(
          (heading, group) -> {
            if (names.containsAll(group)) {
              reported.addAll(group);
              String anchor = heading.toLowerCase(java.util.Locale.ROOT).replace(' ', '-');
              links.add("[" + heading.toLowerCase(java.util.Locale.ROOT) + "](#" + anchor + ")");
            }
          });
      if (reported.contains("--locator")) {
        reported.add("--json");
      }
      own.removeIf(option -> reported.contains(option.longestName()));
      arguments(spec.positionalParameters());
      options(own);
      if (!links.isEmpty()) {
        links.sort(null);
        paragraph("Also the options that say " + String.join(" and ", links) + ".");
      }
    }
    footer(spec.usageMessage().footer());
    verb.getSubcommands().values().forEach(each -> verb(each, depth + "#"));
  }

  private static String synopsis(CommandLine verb) {
    verb.setUsageHelpWidth(WIDE);
    Help help = new Help(verb.getCommandSpec(), Help.defaultColorScheme(Help.Ansi.OFF));
    return help.synopsis(0).strip().replace("[-hV] ", "").replaceAll("\\s+", " ");
  }

  private void arguments(List<PositionalParamSpec> arguments) {
    if (arguments.isEmpty()) {
      return;
    }
    paragraph("| argument | meaning |\n|---|---|");
    text.setLength(text.length() - 1);
    for (PositionalParamSpec each : arguments) {
      row("`" + each.paramLabel() + "`", words(each.description(), each.defaultValueString()));
    }
    text.append('\n');
  }

  private void options(List<OptionSpec> options) {
    List<OptionSpec> reported =
        options.stream().filter(each -> !each.usageHelp() && !each.versionHelp()).toList();
    if (reported.isEmpty()) {
      return;
    }
    paragraph("| option | meaning |\n|---|---|");
    text.setLength(text.length() - 1);
    for (OptionSpec each : reported) {
      String value = each.arity().max() == 0 ? "" : " " + each.paramLabel();
      row(
          "`" + each.longestName() + value + "`",
          words(each.description(), each.defaultValueString()));
    }
    text.append('\n');
  }

  private static String words(String[] description, String standard) {
    return String.join(" ", description)
        .replace("${DEFAULT-VALUE}", standard)
        .replace("%n", " ")
        .replaceFirst("\\.$", "");
  }

  private void row(String name, String meaning) {
    text.append("| ").append(name).append(" | ").append(meaning).append(" |\n");
  }

  /** Blank lines part its paragraphs; indented lines are lists and stay as they are. */
  private void footer(String[] footer) {
    String all = String.join("\n", footer).strip();
    for (String part : all.split("\n\n")) {
      boolean isList = Arrays.stream(part.split("\n")).anyMatch(line -> line.startsWith("  "));
      if (!part.isBlank()) {
        paragraph(isList ? list(part) : part.replace('\n', ' '));
      }
    }
  }

  private static String list(String part) {
    return part.lines()
        .map(line -> line.startsWith("  ") ? "    " + line.strip() : line + "\n")
        .collect(Collectors.joining("\n"));
  }

  private void section(String depth, String heading) {
    text.append(depth).append(' ').append(heading).append("\n\n");
  }

  private void paragraph(String words) {
    if (!words.isBlank()) {
      text.append(words).append("\n\n");
    }
  }
}
