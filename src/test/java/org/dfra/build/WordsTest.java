package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Sources, tests, documents, configuration and scripts use the field's terms, not a language of
 * their own. {@link BannedWords} has the lists.
 */
class WordsTest {

  /** What stays, each with its reason: file and word. */
  private static final Map<String, String> ALLOWED =
      Map.of(
          "docs/reference/robot-xml.md longest_silence",
              "it shows the warning for an old name in a robot's XML",
          "dfra-core/src/test/java/org/dfra/core/effector/DriveImplTest.java longest_silence",
              "it tests that the old name of a parameter works");

  /** Files that are about the old names, each with its reason. */
  private static final Map<String, String> EXEMPT =
      Map.of(
          "docs/reference/renamed.md", "the table of old and new names",
          "src/test/java/org/dfra/build/BannedWords.java", "it contains the lists",
          "src/test/java/org/dfra/build/WordsTest.java", "it tests the lists",
          "dfra-core/src/test/java/org/dfra/core/config/RecordedNamesTest.java",
              "it tests the table of old names",
          "dfra-core/src/test/java/org/dfra/core/config/RenamedNamesTest.java",
              "it tests the table of old names",
          "dfra-sim/src/test/java/org/dfra/sim/world/file/RenamedWorldNamesTest.java",
              "it tests the table of old names");

  /** Not {@code tsv}: {@code renamed-names.tsv} is the table of old names. */
  private static final Pattern TEXT =
      Pattern.compile(
          ".*\\.(?:config|fis|java|kts|md|properties|service|sh|svg|xml|xsd)"
              + "|(?:.*/)?(?:commands|dfra|NOTICE|pack|run)");

  /** Its entries are old and new names. */
  private static final Pattern RENAMED_IN_CHANGELOG =
      Pattern.compile("(?ms)^- \\*\\*Names are the field's terms\\.\\*\\*.*?(?=^- |^#)");

  private static Map<String, String> files;
  private static Set<String> found;

  @BeforeAll
  static void read() throws IOException {
    files = texts();
    found = new TreeSet<>();
    files.forEach((file, text) -> found.addAll(BannedWords.in(file, text)));
  }

  @Test
  void noBannedWordStandsInAnyFile() {
    assertThat(files.keySet().stream().filter(file -> file.contains("/src/main/")))
        .as("files of the main sources")
        .hasSizeGreaterThan(1000);
    assertThat(files.keySet().stream().filter(file -> file.contains("src/test/")))
        .as("files of the tests")
        .hasSizeGreaterThan(500);
    assertThat(files.keySet())
        .contains("CHANGELOG.md", "README.md", "dfra", "pom.xml", "dfra-core/pom.xml")
        .contains("docs/concepts/effectors.md", "config/modules/dsp3000.properties");
    assertThat(found.stream().filter(each -> !ALLOWED.containsKey(each)))
        .as("banned words; docs/reference/glossary.md has the project's terms")
        .isEmpty();
  }

  @Test
  void whatIsAllowedIsStillThere() {
    assertThat(found).as("allowed words that are gone can be struck").containsAll(ALLOWED.keySet());
    for (String file : EXEMPT.keySet()) {
      assertThat(Repository.root().resolve(file)).as("an exempt file").exists();
    }
    assertThat(RENAMED_IN_CHANGELOG.matcher(Repository.read(changelog())).results())
        .as("the entry of the renamed names in CHANGELOG.md")
        .hasSize(1);
  }

  @Test
  void findsWordsInNamesCommentsAndLiterals() {
    assertThat(BannedWords.in("A.java", "int lastHeard; // it was told"))
        .containsExactly("A.java heard", "A.java told");
    assertThat(BannedWords.in("A.java", "static final int TOLD_AGAIN = 1;"))
        .containsExactly("A.java told");
    assertThat(BannedWords.in("A.java", "String s = \"it said\\nanew\"; char c = '\"';"))
        .containsExactly("A.java anew");
    assertThat(BannedWords.in("A.java", "String s = \"\"\"\n  Lots of \"quotes\".\n\"\"\";"))
        .containsExactly("A.java lots");
    assertThat(BannedWords.in("A.java", "/** {@code Helm} is gone. */"))
        .containsExactly("A.java helm");
    assertThat(BannedWords.in("A.java", "int batons, tolder; // untold")).isEmpty();
  }

  @Test
  void findsWordsThatAreBannedInNamesOnly() {
    assertThat(BannedWords.in("A.java", "void tellAll() {} // letters and tells"))
        .containsExactly("A.java tell");
    assertThat(BannedWords.in("A.java", "String s = \"it has been apart\";")).isEmpty();
    assertThat(BannedWords.in("a.md", "It has been apart.")).isEmpty();
  }

  @Test
  void findsWholeNames() {
    assertThat(BannedWords.in("A.java", "double next(Random lot) { return lot.next(); }"))
        .containsExactly("A.java lot");
    assertThat(BannedWords.in("A.java", "Object lotNumber; String s = \"a lot\"; // room"))
        .isEmpty();
  }

  @Test
  void findsWordsInTheNamesOfFiles() {
    assertThat(BannedWords.in("docs/017-letters.md", "Events."))
        .containsExactly("docs/017-letters.md letters");
    assertThat(BannedWords.in("src/HelmTest.java", "")).containsExactly("src/HelmTest.java helm");
  }

  @Test
  void findsIdentifiersInTheRoleInWhichTheyAreBanned() {
    assertThat(BannedWords.in("A.java", "record Methods(int a) { class Eye {} }"))
        .containsExactly("A.java Eye", "A.java Methods");
    assertThat(BannedWords.in("A.java", "import a.Methods; Methods methods; int eye;")).isEmpty();
    assertThat(BannedWords.in("A.java", "private void rest() {}")).containsExactly("A.java rest");
    assertThat(BannedWords.in("A.java", "int rest = other.rest();")).isEmpty();
    assertThat(BannedWords.in("A.java", "void set(double bias, int a) {}"))
        .containsExactly("A.java bias");
    assertThat(BannedWords.in("A.java", "record Noise(double sigma, double white) {}"))
        .containsExactly("A.java white");
    assertThat(BannedWords.in("A.java", "double bias = f(() -> bias, gyroBias);")).isEmpty();
  }

  @Test
  void findsWordsInOtherFiles() {
    assertThat(BannedWords.in("a.md", "Run `aTest.itIsTold`, and Whoever asks."))
        .containsExactly("a.md told", "a.md whoever");
    assertThat(BannedWords.in("a.xml", "<!-- knock --><parameter name=\"longest_silence\"/>"))
        .containsExactly("a.xml knock", "a.xml longest_silence");
  }

  @Test
  void readsTheRestOfTheChangelog() {
    String text = "# Log\n\n- told\n- **Names are the field's terms.** `obey`\n  - heard\n- anew\n";
    assertThat(BannedWords.in("a.md", RENAMED_IN_CHANGELOG.matcher(text).replaceAll("")))
        .containsExactly("a.md anew", "a.md told");
  }

  private static Path changelog() {
    return Repository.root().resolve("CHANGELOG.md");
  }

  /** Whether a build has written it: reports of tests name tests that are renamed since. */
  private static boolean isBuilt(Path root, Path file) {
    for (Path part : root.relativize(file)) {
      String name = part.toString();
      if (name.equals("target") || name.equals("build") && !file.toString().endsWith(".java")) {
        return true;
      }
    }
    return false;
  }

  /** The text of each file that is checked, by its path below the top directory. */
  private static Map<String, String> texts() throws IOException {
    Path root = Repository.root();
    List<Path> all = new ArrayList<>();
    try (Stream<Path> top = Files.list(root)) {
      top.filter(Files::isRegularFile).forEach(all::add);
    }
    List<Path> folders = new ArrayList<>();
    for (String folder : List.of(".ci", ".github", "benchmarks", "config", "docs", "src")) {
      folders.add(root.resolve(folder));
    }
    for (Path module : Repository.modulesWith(root, "pom.xml")) {
      all.add(module.resolve("pom.xml"));
      all.add(module.resolve("build.gradle.kts"));
      folders.add(module.resolve("src"));
    }
    for (Path folder : folders) {
      if (Files.isDirectory(folder)) {
        try (Stream<Path> below = Files.walk(folder)) {
          below.filter(file -> Files.isRegularFile(file) && !isBuilt(root, file)).forEach(all::add);
        }
      }
    }
    Map<String, String> texts = new TreeMap<>();
    for (Path each : all) {
      String name = root.relativize(each).toString().replace('\\', '/');
      if (TEXT.matcher(name).matches() && !EXEMPT.containsKey(name) && Files.exists(each)) {
        texts.put(name, Files.readString(each));
      }
    }
    texts.computeIfPresent(
        "CHANGELOG.md", (name, text) -> RENAMED_IN_CHANGELOG.matcher(text).replaceAll(""));
    return texts;
  }
}
