package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The tables of {@code docs/reference/behaviors.md} are those of the code. */
class BehaviorsReferenceTest {

  private static final Path FILE = Documents.ROOT.resolve("docs/reference/behaviors.md");

  /** A section that a class stands for. */
  private static final Pattern SECTION =
      Pattern.compile("(?ms)^## \\w+\\n\\n`(config/\\S+)`, class `(\\w+)`(.*?)(?=^## |\\z)");

  private static final Pattern ROW =
      Pattern.compile("(?m)^\\| `(\\w+)` \\| ?([^|]*?) ?\\| ?([^|]*?) ?\\| ?([^|]*?) ?\\|");

  /** Where the code asks for a parameter. */
  private static final Pattern ASKED =
      Pattern.compile(
          "(?:settings(?:\\(\\))?\\s*\\.(?:number|seconds|find|text)\\(\\s*"
              + "|ModuleDependency\\.of\\(\\s*context,\\s*\\w+\\.class,\\s*"
              + "|declareInput\\(\\s*\\w+\\.class,\\s*"
              + "|parameterTable\\(\\)\\s*\\.(?:declareReadOnly|declareText|declareNumber)\\(\\s*)\"(\\w+)\"");

  private static final Pattern NUMBER =
      Pattern.compile(
          "(?:number|declareNumber)\\(\\s*\"(\\w+)\",\\s*([^,]+),\\s*([-\\w.]+),\\s*([-\\w.]+)\\)");

  @Test
  void everyModuleOfASearchHasASection() throws Exception {
    List<String> drivers =
        SECTION.matcher(Files.readString(FILE)).results().map(found -> found.group(2)).toList();
    try (Stream<Path> modules = Files.list(Documents.ROOT.resolve("config/modules"))) {
      for (Path each : modules.toList()) {
        String text = Files.readString(each);
        if (text.contains("docs/reference/behaviors.md")) {
          assertThat(drivers).as("%s", each).anyMatch(name -> text.contains("." + name + "\n"));
        }
      }
    }
  }

  @Test
  void everyParameterIsListedWithItsRangeAndNoOther() throws Exception {
    String text = Files.readString(FILE);
    int[] ranges = {0};
    for (MatchResult section : SECTION.matcher(text).results().toList()) {
      assertThat(Documents.ROOT.resolve(section.group(1))).exists();
      compare(section.group(2), section.group(3), source(section.group(2)), ranges);
    }
    String common = text.substring(text.indexOf("### Every perceptual"), text.indexOf("## RangeF"));
    String both = source("PerceptualSchemaImpl") + source("BehaviorImpl");
    compare("what all have in common", common, both, ranges);
    assertThat(ranges[0]).as("ranges compared").isGreaterThan(25);
  }

  private static void compare(String name, String section, String source, int[] ranges) {
    TreeSet<String> asked = new TreeSet<>();
    ASKED.matcher(source).results().forEach(found -> asked.add(found.group(1)));
    Map<String, MatchResult> reported = new TreeMap<>();
    ROW.matcher(section).results().forEach(row -> reported.put(row.group(1), row));
    assertThat(reported.keySet()).as(name).isEqualTo(asked);
    Map<String, MatchResult> numbers = new HashMap<>();
    NUMBER.matcher(source).results().forEach(found -> numbers.put(found.group(1), found));
    numbers.forEach(
        (parameter, number) -> {
          MatchResult row = reported.get(parameter);
          same(name, parameter, number.group(3), row.group(3));
          same(name, parameter, number.group(4), row.group(4));
          if (number.group(2).matches("[0-9.]+") && row.group(2).matches("[0-9].*")) {
            same(name, parameter, number.group(2), row.group(2).replaceFirst(" [a-z/]+ *$", ""));
          }
          ranges[0]++;
        });
  }

  private static void same(String module, String parameter, String inCode, String reported) {
    assertThat(new BigDecimal(reported.replace(" ", "")))
        .as("%s of %s", parameter, module)
        .isEqualByComparingTo(new BigDecimal(inCode.replace("_", "")));
  }

  private static String source(String driver) throws Exception {
    try (Stream<Path> files =
        Files.find(
            Documents.ROOT,
            16,
            (path, attributes) ->
                path.endsWith(driver + ".java") && path.toString().contains("main"))) {
      return Files.readString(files.findFirst().orElseThrow());
    }
  }
}
