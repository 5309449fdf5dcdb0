package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.dfra.app.Main;
import org.dfra.docs.Documents.Document;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/** What the documents say to type is understood. */
class CommandsTest {

  private static final CommandLine DFRA = new CommandLine(Main.class);

  private static final Pattern TYPED =
      Pattern.compile("(?:^|[\\s(;&\"])\\./dfra\\b(?!/)([^#;&|]*)");

  /** The options that the script itself knows of {@code test}, in its {@code case}. */
  private static Set<String> testOptions() {
    String script = Documents.read(Documents.ROOT.resolve("dfra"));
    String runTests =
        script.substring(script.indexOf("run_tests() {"), script.indexOf("test_alone() {"));
    return Pattern.compile("(?m)^ +((?:-{1,2}[a-z]+)(?: \\| -{1,2}[a-z]+)*)\\)")
        .matcher(runTests)
        .results()
        .flatMap(found -> Arrays.stream(found.group(1).split(" \\| ")))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  @Test
  void everyCommandInTheDocumentsIsKnown() {
    List<String> wrong = new ArrayList<>();
    int seen = 0;
    for (Document document : Documents.all()) {
      for (String code : document.code()) {
        if (code.startsWith("dfra: ")) {
          continue; // what the command says, not what is typed
        }
        Matcher typed = TYPED.matcher(code);
        while (typed.find()) {
          seen++;
          String fault = fault(typed.group(1).strip());
          if (fault != null) {
            wrong.add(document.name() + ": ./dfra" + typed.group(1) + ": " + fault);
          }
        }
      }
    }
    assertThat(wrong).isEmpty();
    assertThat(seen).as("commands in the documents").isGreaterThan(20);
  }

  @Test
  void tellsAWrongCommandFromARightOne() {
    assertThat(fault("")).isNull();
    assertThat(fault("demo foundation --record benchmarks/foundation.csv")).isNull();
    assertThat(fault("robot --port=1199 config/robots/atrv1.xml")).isNull();
    assertThat(fault("test --full --java /usr/lib/jvm/java-21")).isNull();
    assertThat(fault("fly")).isEqualTo("there is no verb fly");
    assertThat(fault("demo nosuch")).isEqualTo("there is no demonstration nosuch");
    assertThat(fault("robot --up")).isEqualTo("robot has no option --up");
    assertThat(fault("test --quick")).isEqualTo("test has no option --quick");
  }

  /** What is wrong with the arguments of {@code ./dfra}, or null. */
  private static String fault(String arguments) {
    List<String> words =
        Arrays.stream(arguments.split("\\s+"))
            .map(word -> word.replaceAll("[\\[\\],.:…]+$|^\\[", ""))
            .filter(word -> !word.isEmpty())
            .toList();
    if (words.isEmpty()) {
      return null;
    }
    String verb = words.get(0);
    if (verb.equals("test")) {
      return unknownOption(verb, words, testOptions());
    }
    if (verb.startsWith("-")) {
      return unknownOption("dfra", words, DFRA.getCommandSpec().optionsMap().keySet());
    }
    if (verb.equals("VERB")) {
      return null;
    }
    CommandLine line = DFRA.getSubcommands().get(verb);
    if (line == null) {
      return "there is no verb " + verb;
    }
    if (verb.equals("demo")) {
      return wrongDemo(line, words);
    }
    return unknownOption(verb, words, line.getCommandSpec().optionsMap().keySet());
  }

  private static String wrongDemo(CommandLine line, List<String> words) {
    if (words.size() > 1 && words.get(1).matches("[a-z]+")) {
      boolean listed = line.getUsageMessage().contains("\n  " + words.get(1) + " ");
      if (!listed) {
        return "there is no demonstration " + words.get(1);
      }
    }
    return unknownOption("demo", words, line.getCommandSpec().optionsMap().keySet());
  }

  private static String unknownOption(String verb, List<String> words, Set<String> known) {
    return words.stream()
        .filter(word -> word.startsWith("-") && !word.matches("-\\d+")) // -1 is a value
        .map(word -> word.replaceFirst("=.*", ""))
        .filter(option -> !known.contains(option))
        .findFirst()
        .map(option -> verb + " has no option " + option)
        .orElse(null);
  }

  @Test
  void theReferenceListsEveryVerbAndOptionAndNoOther() {
    Map<String, Set<String>> known = new TreeMap<>();
    DFRA.getSubcommands().forEach((verb, line) -> known.put(verb, options(line.getCommandSpec())));
    known.put("test", withoutHelp(testOptions()));

    Map<String, Set<String>> documented = new TreeMap<>();
    String verb = "";
    for (String line : Documents.of("docs/reference/command-line.md").text().lines().toList()) {
      Matcher heading = Pattern.compile("## `\\./dfra (\\w+)`").matcher(line);
      if (heading.matches()) {
        verb = heading.group(1);
        documented.put(verb, new TreeSet<>());
      }
      Matcher row = Pattern.compile("\\| `(-{1,2}[\\w-]+)[^`]*` \\|.*").matcher(line);
      if (row.matches() && !verb.isEmpty()) {
        documented.get(verb).add(row.group(1));
      }
    }
    assertThat(documented).isEqualTo(known);
  }

  @Test
  void theReferenceNamesTheDefaults() {
    CommandSpec robot = DFRA.getSubcommands().get("robot").getCommandSpec();
    String reference = Documents.of("docs/reference/command-line.md").text();
    for (String option : List.of("--port", "--registry-port")) {
      assertThat(reference)
          .containsPattern(
              "\\| `"
                  + option
                  + " PORT` \\| `"
                  + robot.findOption(option).defaultValueString()
                  + "` \\|");
    }
  }

  private static Set<String> options(CommandSpec spec) {
    return withoutHelp(
        spec.options().stream()
            .map(option -> option.longestName())
            .collect(Collectors.toCollection(TreeSet::new)));
  }

  private static Set<String> withoutHelp(Set<String> options) {
    Set<String> rest = new TreeSet<>(options);
    rest.removeAll(Set.of("-h", "--help", "-V", "--version"));
    return rest;
  }
}
