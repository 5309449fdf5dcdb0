package org.dfra.cli.completion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dfra.cli.Main;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The script that is printed completes real words in real shells. */
class CompletionTest {

  @TempDir static Path folder;

  private static Path script;

  @BeforeAll
  static void print() throws IOException {
    script = folder.resolve("dfra.completion");
    try (PrintWriter out = new PrintWriter(Files.newBufferedWriter(script))) {
      int status = Main.commandLine().setOut(out).execute("completion", "bash");
      assertThat(status).isZero();
    }
  }

  @ParameterizedTest
  @CsvSource({
    "dfra mod, module",
    "./dfra mod, module",
    "/opt/dfra/bin/dfra mod, module",
    "dfra module l, list",
    "./dfra module l, list",
    "dfra module list --js, --json",
    "dfra completion z, zsh",
    "dfra doctor --lo, --locator",
    "dfra te, test",
    "dfra test --int, --integration",
    "dfra test --so, --soak",
    "dfra test --se, --seed",
    "dfra di, dist",
  })
  void bashCompletes(String typed, String word) throws Exception {
    assumeTrue(isInstalled("bash"), "bash is not installed here");
    assertThat(bash(typed)).contains(word);
  }

  @Test
  void bashShowsAllVerbsWhereNothingIsTyped() throws Exception {
    assumeTrue(isInstalled("bash"), "bash is not installed here");
    assertThat(bash("dfra ")).contains("up", "down", "status", "module", "doctor", "completion");
    assertThat(bash("dfra module frob")).isEmpty();
  }

  @Test
  void zshCompletes() throws Exception {
    assumeTrue(isInstalled("zsh"), "zsh is not installed here");
    // Completion itself needs a terminal; that it is in place, and what bash's function answers,
    // does not.
    String reported =
        run(
            "zsh",
            "-f",
            "-c",
            """
            autoload -U +X compinit && compinit -u -D
            source "$1"
            print -r -- "place: ${_comps[dfra]}"
            COMP_WORDS=(dfra mod); COMP_CWORD=1; COMP_LINE='dfra mod'; COMPREPLY=()
            print -r -- "function: ${+functions[_complete_dfra]}"
            """,
            "zsh",
            script.toString());
    assertThat(reported).contains("_complete_dfra", "function: 1");
  }

  /** What bash would put at the end of a line at the stroke of the tabulator. */
  private List<String> bash(String typed) throws Exception {
    String[] words = typed.split(" ", -1);
    String reported =
        run(
            "bash",
            "--norc",
            "-c",
            """
            source "$1"
            shift
            COMP_LINE="$*" COMP_POINT=${#COMP_LINE}
            COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
            # The function that bash itself would take: for a path, that of the last name in it.
            spec=$(complete -p -- "${1##*/}") || exit 1
            function=$(sed 's/.*-F \\([^ ]*\\).*/\\1/' <<<"$spec")
            compopt() { :; } # only known while a completion runs
            "$function" "$1" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
            printf '%s\\n' "${COMPREPLY[@]}"
            """,
            Stream.concat(Stream.of("bash", script.toString()), Arrays.stream(words))
                .toArray(String[]::new));
    return reported.lines().map(String::strip).filter(line -> !line.isEmpty()).toList();
  }

  private static String run(String shell, String flag, String c, String code, String... arguments)
      throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(
                Stream.concat(Stream.of(shell, flag, c, code), Arrays.stream(arguments)).toList())
            .redirectErrorStream(true)
            .start();
    process.getOutputStream().close();
    String reported = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor(30, TimeUnit.SECONDS)).as("%s still runs", shell).isTrue();
    assertThat(process.exitValue()).as(reported).isZero();
    return reported;
  }

  private static boolean isInstalled(String shell) {
    return Stream.of(System.getenv("PATH").split(File.pathSeparator))
        .anyMatch(each -> Files.isExecutable(Path.of(each, shell)));
  }
}
