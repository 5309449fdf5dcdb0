package org.dfra.river.bootstrap;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Starts a command so that it outlives the terminal and the script that started it.
 *
 * <p>A terminal sends SIGINT (Ctrl-C) and SIGHUP (on close) to its process group. Java starts
 * children in its own group; {@code setsid} of util-linux starts a new session. If that program is
 * missing, for example on macOS, the command and its children ignore these two signals instead. In
 * both cases the process keeps its ID, and SIGTERM ends it.
 */
public final class DetachedCommand {

  private static final List<String> IGNORING =
      List.of("/bin/sh", "-c", "trap '' INT HUP; exec \"$@\"", "sh");

  private DetachedCommand() {}

  /**
   * The words to put before the command.
   *
   * @param path the search path for programs, as in PATH; null for none
   */
  public static List<String> prefix(@Nullable String path) {
    return Stream.of(path == null ? new String[0] : path.split(Pattern.quote(File.pathSeparator)))
        .filter(folder -> !folder.isEmpty())
        .map(folder -> Path.of(folder, "setsid"))
        .filter(Files::isExecutable)
        .findFirst()
        .map(program -> List.of(program.toAbsolutePath().toString()))
        .orElse(IGNORING);
  }
}
