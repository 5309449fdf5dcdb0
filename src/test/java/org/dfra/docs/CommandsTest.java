package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.dfra.cli.Main;
import org.dfra.docs.Documents.Document;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;

/** What the documents say to type is understood. */
class CommandsTest {

  private static final CommandLine DFRA = Main.commandLine();

  private static final Pattern TYPED =
      Pattern.compile("(?:^|[\\s(;&\"])\\./dfra\\b(?!/)([^#;&|]*)");

  private static final String REFERENCE = "docs/reference/command-line.md";
  private static final String BEGIN = "<!-- From here on the commands tell of themselves. -->";
  private static final String END = "<!-- So far the commands. -->";

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
  void distinguishesAWrongCommandFromARightOne() {
    assertThat(fault("")).isNull();
    assertThat(fault("demo foundation --record benchmarks/foundation.csv")).isNull();
    assertThat(fault("up --port=1199 config/robots/atrv1.xml")).isNull();
    assertThat(fault("module list --json")).isNull();
    assertThat(fault("module fly")).isEqualTo("there is no verb module fly");
    assertThat(fault("module list --fast")).isEqualTo("module list has no option --fast");
    assertThat(fault("test --full --java /usr/lib/jvm/java-21")).isNull();
    assertThat(fault("test --seed -42")).isNull();
    assertThat(fault("fly")).isEqualTo("there is no verb fly");
    assertThat(fault("demo nosuch")).isEqualTo("there is no demonstration nosuch");
    assertThat(fault("up --down")).isEqualTo("up has no option --down");
    assertThat(fault("dist --quick")).isEqualTo("dist has no option --quick");
    assertThat(fault("build")).isNull();
    assertThat(fault("build --quick")).isEqualTo("build has no option --quick");
    assertThat(fault("javadoc --help")).isNull();
    assertThat(fault("javadoc --quick")).isEqualTo("javadoc has no option --quick");
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
    if (verb.equals("dist")) {
      return unknownOption(
          verb,
          words,
          Set.of("-h", "--help", "--flight", "--complete", "--sign", "--sign-passphrase-file"));
    }
    if (verb.equals("build") || verb.equals("javadoc")) {
      return unknownOption(verb, words, Set.of("-h", "--help"));
    }
    if (verb.startsWith("-")) {
      return unknownOption("dfra", words, DFRA.getCommandSpec().optionsMap().keySet());
    }
    if (verb.equals("COMMAND")) {
      return null;
    }
    CommandLine line = DFRA.getSubcommands().get(verb);
    if (line == null) {
      return "there is no verb " + verb;
    }
    if (verb.equals("demo")) {
      return wrongDemo(line, words);
    }
    if (!line.getSubcommands().isEmpty() && words.size() > 1) {
      String second = words.get(1);
      CommandLine nested = line.getSubcommands().get(second);
      if (nested == null && !second.startsWith("-") && !second.equals("COMMAND")) {
        return "there is no verb " + verb + " " + second;
      }
      line = nested == null ? line : nested;
    }
    return unknownOption(
        line.getCommandSpec().qualifiedName(" ").replaceFirst("^dfra ", ""),
        words,
        line.getCommandSpec().optionsMap().keySet());
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
  void theReferenceIsWhatTheCommandsPrint() throws IOException {
    String reference = Documents.of(REFERENCE).text();
    int begin = reference.indexOf(BEGIN) + BEGIN.length();
    int end = reference.indexOf(END);
    assertThat(begin).as("place of " + BEGIN).isBetween(BEGIN.length(), end);
    String right =
        reference.substring(0, begin)
            + "\n\n"
            + CommandReference.of(Main.commandLine())
            + "\n"
            + reference.substring(end);
    Path draft = Documents.ROOT.resolve("target/command-line.md");
    if (!reference.equals(right)) {
      Files.createDirectories(draft.getParent());
      Files.writeString(draft, right);
    }
    assertThat(reference)
        .as("%s; the commands have changed: move %s there", REFERENCE, draft)
        .isEqualTo(right);
  }

  @Test
  void theReferenceNamesEveryOptionOfTest() {
    String reference = Documents.of(REFERENCE).text();
    assertThat(testOptions()).contains("--full", "--soak", "--java", "--seed");
    for (String option : testOptions()) {
      if (!Set.of("-h", "--help").contains(option)) {
        assertThat(reference).containsPattern("\\| `" + option + "[^`]*` \\|");
      }
    }
  }
}
