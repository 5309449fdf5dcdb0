package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.dfra.core.host.PrivateFiles;

/**
 * Permits the groups of a phoenix what {@code ./dfra} starts virtual machines with, its class path
 * above all. A phoenix that runs for long was started with older jars than the groups that are
 * registered today, and permits by itself only its own.
 *
 * <p>It is permitted by a file in the private state folder, which phoenix reads at each
 * registration. So no call, whoever makes it, can name a class path that phoenix's own user has not
 * written down.
 */
final class PermittedLaunchOptions {

  /** Written by {@code ./dfra}, anew for each phoenix. */
  private static final String LAUNCHED = "launch.options";

  /** Written by the user, never by {@code ./dfra}. */
  private static final String PERMITTED = "permitted.options";

  private PermittedLaunchOptions() {}

  /** The files that permit options, one a line, the user's last. */
  static List<Path> files(Path state) {
    return List.of(state.resolve(LAUNCHED), state.resolve(PERMITTED));
  }

  /** Forgets what was permitted for a former phoenix. Called while none runs. */
  static void clear(Path state) throws IOException {
    Files.deleteIfExists(state.resolve(LAUNCHED));
  }

  /** Permits a group's options, where they are not permitted yet. */
  static void permit(Path state, List<String> options) throws IOException {
    Path file = state.resolve(LAUNCHED);
    PrivateFiles.makeFile(file);
    List<String> missing = lines(options);
    missing.removeAll(Set.copyOf(Files.readAllLines(file, StandardCharsets.UTF_8)));
    if (!missing.isEmpty()) {
      // In one write, so that commands that run at the same time keep each other's lines whole.
      Files.writeString(
          file,
          String.join("\n", missing) + "\n",
          StandardCharsets.UTF_8,
          StandardOpenOption.APPEND);
    }
  }

  /** A class path and its option are one line. */
  private static List<String> lines(List<String> options) {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < options.size(); i++) {
      boolean isClassPath = options.get(i).equals("-cp") && i + 1 < options.size();
      lines.add(isClassPath ? "-cp " + options.get(++i) : options.get(i));
    }
    return lines;
  }
}
