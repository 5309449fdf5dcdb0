package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Reports of tests that a pretended build tool leaves when it is run: it executes the file {@code
 * during}.
 */
final class PretendedReports {

  /** What Surefire writes of a class, shortened. */
  private static final String REPORT =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <testsuite xmlns:xsi="x" version="3.0.2" name="org.dfra.%1$s" time="%2$s" tests="2" errors="0" skipped="0" failures="%3$d">
        <testcase name="good" classname="org.dfra.%1$s" time="0.1"/>
        <testcase name="bad" classname="org.dfra.%1$s" time="%2$s">
          %4$s
        </testcase>
      </testsuite>
      """;

  /** In a second report: the bound is kept. */
  static final String GOOD = " ";

  /** In a second report: the bound is missed again. */
  static final String BAD = "<failure message=\"was 3\" type=\"x\"/>";

  private final Path folder;

  /**
   * @param folder where the build tool runs
   */
  PretendedReports(Path folder) {
    this.folder = folder;
  }

  /** Makes the build tool leave a module's report, as a run of it would. */
  void leave(String module, String test, String seconds, boolean failed) throws IOException {
    Path reports = folder.resolve(module).resolve("target/surefire-reports");
    String failure = failed ? "<failure message=\"was 2\" type=\"x\"/>" : "";
    Path during = folder.resolve("during");
    String script = Files.exists(during) ? Files.readString(during) : "";
    Files.writeString(
        during,
        script
            + "mkdir -p '%s'\ncat >'%s' <<'END'\n%sEND\n"
                .formatted(
                    reports,
                    reports.resolve("TEST-org.dfra." + test + ".xml"),
                    REPORT.formatted(test, seconds, failed ? 1 : 0, failure)));
    assertThat(during.toFile().setExecutable(true)).isTrue();
  }

  /**
   * What the build tool leaves of a class that misses a bound during an overload, and, if it gets
   * one, a second report where it is run again.
   */
  void leaveMiss(String reports, String test, String more, String second) throws IOException {
    Path during = folder.resolve("during");
    String script = Files.exists(during) ? Files.readString(during) : "";
    Path report = folder.resolve(reports).resolve("TEST-org.dfra." + test + ".xml");
    String missed =
        "<system-out><![CDATA[MISSED DURING AN OVERLOAD: it took 3 s]]></system-out>" + more;
    int failed = more.isEmpty() ? 0 : 1;
    Files.writeString(
        during,
        script
            + """
            mkdir -p '%1$s'
            case "$*" in
                *dfra.test.repeats=false*)
                    for each in "$@"; do echo "$each"; done >again
                    [ -z '%5$s' ] || cat >'%2$s' <<'END'
            %4$sEND
                    ;;
                *dfra.test.repeats=true*)
                    cat >'%2$s' <<'END'
            %3$sEND
                    ;;
            esac
            """
                .formatted(
                    report.getParent(),
                    report,
                    REPORT.formatted(test, "9", failed, missed),
                    REPORT.formatted(test, "2", second.equals(BAD) ? 1 : 0, second),
                    second));
    assertThat(during.toFile().setExecutable(true)).isTrue();
  }
}
