package org.dfra.examples.security;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.cli.Main;
import org.dfra.core.host.CommandName;
import org.dfra.core.host.PrivateFiles;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.river.security.SecureProcess;
import org.jspecify.annotations.Nullable;

/**
 * The command line as the members of a team type it, each on a computer of its own: a state folder.
 * Every command is a process; it is shown with what it prints. Thread-safe.
 */
final class MemberCommands {

  private static final String OURS = "DFRA_";
  private static final String LIB = "dfra.lib";

  private final DemoEnvironment environment;
  private final ProgressReporter progress;
  private final Map<String, String> variables;
  private final Path root = Path.of(System.getProperty("dfra.root", "")).toAbsolutePath();

  /**
   * @param environment records the processes; its folder is where the commands are typed
   * @param variables environment variables of all commands
   */
  MemberCommands(
      DemoEnvironment environment, ProgressReporter progress, Map<String, String> variables) {
    this.environment = environment;
    this.progress = progress;
    this.variables = new TreeMap<>(variables);
  }

  /** The state folder of a member, or of somebody who has joined no team. */
  Path state(String who) {
    return environment.folder().resolve(who);
  }

  /** The folder of a member's identity. */
  Path security(String who) {
    return SecureProcess.folder(state(who));
  }

  /**
   * Types a command and shows it with its output.
   *
   * @param who types it
   * @param words of the command
   * @return the lines that it prints
   * @throws IOException if it fails
   */
  List<String> type(String who, String... words) throws IOException, InterruptedException {
    List<String> lines = run(who, words);
    show(who, lines, words);
    return lines;
  }

  /**
   * Types a command and shows it with the first lines of its output.
   *
   * @param lines how many
   */
  void typeBriefly(String who, int lines, String... words)
      throws IOException, InterruptedException {
    show(who, first(lines, run(who, words)), words);
  }

  /** The first lines of an output, and how many follow. */
  static List<String> first(int most, List<String> lines) {
    if (lines.size() <= most) {
      return lines;
    }
    List<String> first = new ArrayList<>(lines.subList(0, most));
    if (most > 1) {
      first.add("… (" + (lines.size() - most) + " more lines)");
    }
    return first;
  }

  /** Shows a command with lines of its output. */
  void show(String who, List<String> lines, String... words) {
    List<String> shown = new ArrayList<>();
    shown.add(shown(typed(who, words)));
    lines.forEach(line -> shown.add("  " + shown(line)));
    progress.show(shown);
  }

  private static String typed(String who, String... words) {
    return who + "$ " + CommandName.current() + " " + String.join(" ", words);
  }

  /** As on a computer where DFRA is the present folder, and the team's files lie in it. */
  private String shown(String text) {
    return text.replace(environment.folder() + "/", "").replace(root + "/", "");
  }

  /**
   * Runs a command without showing it.
   *
   * @return the lines that it prints
   * @throws IOException if it fails
   */
  List<String> run(String who, String... words) throws IOException, InterruptedException {
    return run(who, Map.of(), words);
  }

  /**
   * As {@link #run(String, String...)}.
   *
   * @param more further environment variables
   */
  List<String> run(String who, Map<String, String> more, String... words)
      throws IOException, InterruptedException {
    PrivateFiles.requireFolder(state(who));
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    command.add("-Ddfra.root=" + root);
    @Nullable String lib = System.getProperty(LIB);
    if (lib != null) { // with the jars that robots serve
      command.add("-D" + LIB + "=" + Path.of(lib).toAbsolutePath());
    }
    command.add(Main.class.getName());
    command.addAll(List.of(words));
    ProcessBuilder builder =
        new ProcessBuilder(command)
            .directory(environment.folder().toFile())
            .redirectErrorStream(true);
    Map<String, String> own = builder.environment();
    own.keySet().removeIf(name -> name.startsWith(OURS)); // the user's settings are for others
    own.putAll(variables);
    own.putAll(more);
    own.put("DFRA_STATE", state(who).toString());
    Process process = builder.start();
    environment.remember(process.toHandle());
    process.getOutputStream().close();
    List<String> lines = new ArrayList<>();
    try (BufferedReader out = process.inputReader(StandardCharsets.UTF_8)) {
      out.lines().forEach(lines::add);
    }
    int exit = process.waitFor();
    if (exit != 0) {
      throw new IOException(
          shown(typed(who, words) + " has exit code " + exit + ": " + String.join(" ", lines)));
    }
    return lines;
  }

  /** A file of the folder in which the commands are typed. */
  Path file(String name) {
    return environment.folder().resolve(name);
  }

  /** Replaces one text in a file by another, as with an editor. */
  static void edit(Path file, String before, String after) throws IOException {
    String text = Files.readString(file);
    if (!text.contains(before)) {
      throw new IOException(file + " does not contain " + before);
    }
    Files.writeString(file, text.replace(before, after));
  }
}
