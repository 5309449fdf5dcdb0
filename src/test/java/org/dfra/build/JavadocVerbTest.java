package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * {@code ./dfra javadoc} reports where the pages are, or what Javadoc has reported. The script runs
 * in a folder of its own, with build tools that write pages and reports as a test wants them.
 */
@Timeout(120)
class JavadocVerbTest {

  private static final String BUILD_TOOL =
      """
      #!/bin/sh
      case $1 in
          -v) echo "Apache Maven 3.9.9"; exit ;;
          --version) echo "Gradle 8.7"; exit ;;
      esac
      echo "$*" >>given
      report() { printf '%s\\n' "$1$PWD/dfra-a/src/main/java/org/dfra/A.java:12: $2" "$1 * $3"; }
      . ./tool
      """;

  private static final String REPORT =
      "dfra-a/src/main/java/org/dfra/A.java:12: error: reference not found\n"
          + "    * See {@link Nowhere}.\n";

  @TempDir Path folder;
  private ScriptFolder script;
  private String printed = "";

  @BeforeEach
  void prepare() throws IOException {
    folder = folder.toRealPath();
    script = new ScriptFolder(folder, BUILD_TOOL);
  }

  /** What the build tool does, in the top folder of the checkout. */
  private void tool(String script) throws IOException {
    Files.writeString(folder.resolve("tool"), script);
  }

  /** The exit code of {@code ./dfra javadoc} with these words after it. */
  private int javadoc(String tool, String... words) throws IOException, InterruptedException {
    int code = script.run(tool, "javadoc", words);
    printed = script.printed();
    return code;
  }

  @ParameterizedTest
  @CsvSource({"maven, target, javadoc:aggregate", "gradle, build, :javadoc"})
  void buildsThePagesAndNamesTheFirstOne(String tool, String out, String goal) throws Exception {
    Path old = Files.createDirectories(folder.resolve(out + "/apidocs/org/dfra"));
    Files.writeString(old.resolve("Removed.html"), "of a type that is gone");
    tool(
        """
        mkdir -p %1$s/apidocs/org/dfra/a
        for each in index org/dfra/A org/dfra/a/B org/dfra/a/B.C org/dfra/a/package-summary; do
            echo page >%1$s/apidocs/$each.html
        done
        """
            .formatted(out));
    assertThat(javadoc(tool)).as(printed).isZero();
    assertThat(printed)
        .isEqualTo(
            "dfra: documenting … (log: %1$s/javadoc.log)\n%1$s/apidocs/index.html: 3 types\n"
                .formatted(out));
    assertThat(Files.readString(folder.resolve("given"))).contains(goal);
  }

  /** Maven reports errors twice in some cases; Gradle compiles first, with warnings of its own. */
  @ParameterizedTest
  @CsvSource({"maven, '[ERROR] ', ''", "gradle, '', '> Task :javadoc'"})
  void failsWithFileAndLineOfEachReport(String tool, String prefix, String heading)
      throws Exception {
    tool(
        """
        [ "$DFRA_BUILD" = maven ] || echo "> Task :dfra-a:compileJava"
        [ "$DFRA_BUILD" = maven ] || report "" "warning: [rawtypes] found raw type"
        echo "%2$s"
        report "%1$s" "error: reference not found" "See {@link Nowhere}."
        report "%1$s" "error: reference not found" "See {@link Nowhere}."
        report "%1$s" "warning: empty <p> tag" "<p>"
        exit 1
        """
            .formatted(prefix, heading));
    assertThat(javadoc(tool)).as(printed).isEqualTo(1);
    assertThat(printed)
        .containsOnlyOnce(REPORT)
        .contains("\ndfra-a/src/main/java/org/dfra/A.java:12: warning: empty <p> tag\n    * <p>\n")
        .contains("\ndfra: Javadoc has warnings or errors; correct these lines, then ")
        .doesNotContain("index.html", "raw type");
  }

  /** Also if the build tool takes it for a success. */
  @Test
  void failsIfThereAreBothPagesAndAReport() throws Exception {
    tool(
        """
        mkdir -p target/apidocs/org
        echo page | tee target/apidocs/index.html >target/apidocs/org/A.html
        report "[WARNING] " "error: reference not found" "See {@link Nowhere}."
        """);
    assertThat(javadoc("maven")).as(printed).isEqualTo(1);
    assertThat(printed).contains(REPORT).doesNotContain("index.html");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"exit 1", "mkdir -p target/apidocs && echo page >target/apidocs/index.html"})
  void showsTheEndOfTheLogIfThereAreNoPages(String end) throws Exception {
    tool("echo no plugin of that name\n" + end);
    assertThat(javadoc("maven")).as(printed).isEqualTo(1);
    assertThat(printed)
        .endsWith(
            "no plugin of that name\ndfra: the API documentation was not built; the log is "
                + folder.resolve("target/javadoc.log\n"));
  }

  @Test
  void explainsItselfAndRefusesOptions() throws Exception {
    assertThat(javadoc("maven", "--help")).isZero();
    assertThat(printed).startsWith("usage: ./dfra javadoc\n").contains("target/apidocs");
    assertThat(javadoc("maven", "--quick")).isEqualTo(64);
    assertThat(printed).isEqualTo("dfra: unknown option --quick; usage: ./dfra javadoc\n");
    assertThat(folder.resolve("given")).doesNotExist();
  }
}
