package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** The new names in {@code docs/reference/renamed.md} are names that exist. */
class RenamedTableTest {

  /** A type, perhaps nested, without its package. */
  private static final Pattern TYPE =
      Pattern.compile("(?<![\\w.])(?:[a-z]\\w*\\.)*([A-Z]\\w*(?:\\.[A-Z]\\w*)*)");

  private static final Pattern DECLARATION =
      Pattern.compile("\\b(?:class|interface|record|enum)\\s+([A-Z]\\w*)");

  /** The types that each source file declares, by the file's name without its suffix. */
  private static final Map<String, List<String>> DECLARED = new HashMap<>();

  @BeforeAll
  static void readSources() throws IOException {
    List<Path> folders = new ArrayList<>(List.of(Documents.ROOT.resolve("src")));
    try (Stream<Path> modules = Files.list(Documents.ROOT)) {
      modules
          .filter(folder -> folder.getFileName().toString().startsWith("dfra-"))
          .map(folder -> folder.resolve("src"))
          .filter(Files::isDirectory)
          .forEach(folders::add);
    }
    for (Path folder : folders) {
      try (Stream<Path> below = Files.walk(folder)) {
        for (Path file : below.filter(each -> each.toString().endsWith(".java")).toList()) {
          String name = file.getFileName().toString().replace(".java", "");
          DECLARED
              .computeIfAbsent(name, key -> new ArrayList<>())
              .addAll(
                  DECLARATION
                      .matcher(Files.readString(file))
                      .results()
                      .map(found -> found.group(1))
                      .toList());
        }
      }
    }
  }

  @Test
  void eachOldTypeHasANewNameThatExists() {
    assertThat(DECLARED).hasSizeGreaterThan(1000);
    String types = section("## Types", "## Methods");
    List<String> checked = new ArrayList<>();
    List<String> missing = new ArrayList<>();
    for (String row : types.lines().filter(line -> line.startsWith("| ")).toList()) {
      String[] cells = row.split("\\|");
      TYPE.matcher(cells[2])
          .results()
          .map(found -> found.group(1))
          .forEach(name -> (exists(name) ? checked : missing).add(name + " in" + row));
    }
    assertThat(checked).hasSizeGreaterThan(500);
    assertThat(missing).as("new names of types that no source declares").isEmpty();
  }

  @Test
  void noOldNameHasTwoRowsOfOnePackage() {
    Map<String, Long> rows = new HashMap<>();
    String heading = "";
    for (String line : section("## Types", "## Methods").lines().toList()) {
      heading = line.startsWith("### ") ? line : heading;
      if (line.startsWith("| ") && !line.startsWith("| old")) {
        rows.merge(heading + " " + line.split("\\|")[1].strip(), 1L, Long::sum);
      }
    }
    assertThat(rows).allSatisfy((row, times) -> assertThat(times).as(row).isOne());
  }

  private static boolean exists(String name) {
    String[] parts = name.split("\\.");
    List<String> declared = DECLARED.getOrDefault(parts[0], List.of());
    return declared.containsAll(Arrays.asList(parts));
  }

  private static String section(String from, String to) {
    String text = Documents.read(Documents.ROOT.resolve("docs/reference/renamed.md"));
    MatchResult found =
        Pattern.compile("(?ms)^" + from + "$.*?(?=^" + to + ")")
            .matcher(text)
            .results()
            .findFirst()
            .orElseThrow();
    return found.group();
  }
}
