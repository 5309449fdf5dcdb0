package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dfra.benchmarks.attack.AttackTask.Target;
import org.dfra.cli.Main;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.text.PrintableText;

/**
 * Runs commands of {@code ./dfra} as an operator of the attacked robot, each in a separate process,
 * and checks their output. Not thread-safe.
 */
final class OperatorTerminal {

  private static final String WAIT =
      "20"; // timeout in seconds; reached only if something is missing
  private static final long PATIENCE_SECONDS = 60;

  /** Otherwise a character outside the terminal's encoding would be printed as a question mark. */
  private static final List<String> ENCODING =
      List.of(
          "-Dfile.encoding=UTF-8",
          "-Dstdout.encoding=UTF-8",
          "-Dstderr.encoding=UTF-8",
          "-Dsun.stdout.encoding=UTF-8",
          "-Dsun.stderr.encoding=UTF-8");

  private final Target target;
  private final TerminalCheck check = new TerminalCheck();

  OperatorTerminal(Target target) {
    this.target = target;
  }

  /**
   * Runs a command to its end, whatever its exit code.
   *
   * @throws IOException if it cannot be started or does not end
   */
  void run(String... words) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    command.addAll(ENCODING);
    command.add("-Ddfra.root=" + System.getProperty("dfra.root", "."));
    command.add(Main.class.getName());
    command.addAll(List.of(words));
    command.addAll(
        List.of(
            "--team=",
            "--locator=" + target.host() + ":" + target.registrarPort(),
            "--host=" + target.host(),
            "--wait=" + WAIT,
            "--state=" + target.folder().resolve("operator")));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    check.add(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
    if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
      process.destroyForcibly();
      throw new IOException("the command " + List.of(words) + " does not end");
    }
  }

  /** Whether a command has printed this text. */
  boolean shows(String text) {
    return check.shows(text);
  }

  /**
   * Makes sure that the commands have listed the attacker's registration: an empty listing proves
   * nothing.
   *
   * @param text as commands print it
   * @throws IOException if it was never printed
   */
  void requireShown(String text) throws IOException {
    if (!shows(text)) {
      throw new IOException(
          "no command printed "
              + text
              + ", which the attacker registered; printed were: "
              + PrintableText.line(check.printed()));
    }
  }

  /** The counts. */
  List<MeasuredValue> figures() {
    return check.figures();
  }
}
