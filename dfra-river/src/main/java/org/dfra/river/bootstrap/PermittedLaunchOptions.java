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
 * Permits the groups of a phoenix to use the options with which {@code ./dfra} starts virtual
 * machines, above all the class path. A phoenix that has run for long was started with older jars
 * than the groups that are registered today, and by itself permits only its own.
 *
 * <p>The permission is a file in the private state folder, which phoenix reads at each
 * registration. So no remote call can set a class path that phoenix's own user has not written into
 * that file.
 */
final class PermittedLaunchOptions {

  /** Written by {@code ./dfra}, once for each phoenix. */
  private static final String LAUNCHED = "launch.options";

  /** Written by the user, never by {@code ./dfra}. */
  private static final String PERMITTED = "permitted.options";

  private PermittedLaunchOptions() {}

  /** The files that permit options, one a line, the user's last. */
  static List<Path> files(Path state) {
    return List.of(state.resolve(LAUNCHED), state.resolve(PERMITTED));
  }

  /** Deletes the permissions of a former phoenix. Called while none runs. */
  static void clear(Path state) throws IOException {
    Files.deleteIfExists(state.resolve(LAUNCHED));
  }

  /** Permits a group's options, unless they are already permitted. */
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
