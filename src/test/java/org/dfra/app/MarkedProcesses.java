package org.dfra.app;

import static org.awaitility.Awaitility.await;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.dfra.cli.Main;
import org.dfra.river.bootstrap.JvmCommand;
import picocli.CommandLine;

/**
 * Runs {@link Main} in processes that can be distinguished from all others: a folder that does not
 * exist is the first on their class path, and on that of every process they start.
 */
public final class MarkedProcesses implements AutoCloseable {

  /** What a run said and how it ended. */
  public record Outcome(int exit, String out, String err) {}

  private final Path mark;
  private final List<String> options;
  private final Map<String, String> environment = new HashMap<>();

  /**
   * @param folder a folder of this test alone
   * @param options further options for the first process
   */
  public MarkedProcesses(Path folder, String... options) {
    this.mark = folder.resolve("mark");
    this.options = List.of(options);
    environment.put("DFRA_WAIT", "20"); // where nothing is missing it is not used up
  }

  /** Sets a variable of the processes that are started from now on. */
  public MarkedProcesses set(String variable, String value) {
    environment.put(variable, value);
    return this;
  }

  /** Runs {@code ./dfra} with these arguments, without the script. */
  public Outcome dfra(Duration patience, String... arguments)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    List<String> usual = new ArrayList<>(JvmCommand.options());
    int classPath = usual.size() - 1;
    usual.set(classPath, mark + File.pathSeparator + usual.get(classPath));
    command.addAll(usual);
    command.addAll(options);
    command.add("-Ddfra.root=" + System.getProperty("dfra.root"));
    command.add(Main.class.getName());
    command.addAll(List.of(arguments));
    Path out = mark.resolveSibling("dfra.out");
    Path err = mark.resolveSibling("dfra.err");
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectOutput(out.toFile()).redirectError(err.toFile());
    builder.environment().putAll(environment);
    Process process = builder.start();
    if (!process.waitFor(patience.toMillis(), TimeUnit.MILLISECONDS)) {
      close();
      throw new AssertionError(
          "./dfra "
              + String.join(" ", arguments)
              + " still runs after "
              + patience.toSeconds()
              + " s; it said: "
              + java.nio.file.Files.readString(out));
    }
    return new Outcome(
        process.exitValue(),
        java.nio.file.Files.readString(out, StandardCharsets.UTF_8),
        java.nio.file.Files.readString(err, StandardCharsets.UTF_8));
  }

  /**
   * Runs {@code ./dfra} with these arguments in the test's own process: with the same answer, but
   * without a virtual machine that first has to start, for what asks and starts nothing. Variables
   * that were {@link #set} do not count here.
   */
  public static Outcome here(String... arguments) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine line = Main.commandLine(arguments);
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    return new Outcome(line.execute(arguments), out.toString(), err.toString());
  }

  /** Every process with this mark that lives now. */
  public List<ProcessHandle> living() {
    return ProcessHandle.allProcesses()
        .filter(each -> each.info().commandLine().orElse("").contains(mark.toString()))
        .filter(ProcessHandle::isAlive)
        .toList();
  }

  /** Kills what is left. */
  @Override
  public void close() {
    living().forEach(ProcessHandle::destroyForcibly);
    await().atMost(Duration.ofSeconds(10)).until(() -> living().isEmpty());
  }
}
