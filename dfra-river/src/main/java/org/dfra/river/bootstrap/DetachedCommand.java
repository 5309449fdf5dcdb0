package org.dfra.river.bootstrap;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * How a command is started so that it outlives the terminal and the script it is started from.
 *
 * <p>A terminal sends SIGINT (Ctrl-C) and SIGHUP (its end) to its process group. Java starts
 * children in its own group, and cannot do otherwise; {@code setsid} of util-linux does. Where
 * there is no such program, on macOS say, the command and all that it starts ignore these two
 * signals instead. In both cases the process keeps its number, and SIGTERM ends it.
 */
final class DetachedCommand {

  private static final List<String> IGNORING =
      List.of("/bin/sh", "-c", "trap '' INT HUP; exec \"$@\"", "sh");

  private DetachedCommand() {}

  /**
   * What goes before the command.
   *
   * @param path the folders in which programs are looked for, as in PATH; null for none
   */
  static List<String> prefix(@Nullable String path) {
    return Stream.of(path == null ? new String[0] : path.split(Pattern.quote(File.pathSeparator)))
        .filter(folder -> !folder.isEmpty())
        .map(folder -> Path.of(folder, "setsid"))
        .filter(Files::isExecutable)
        .findFirst()
        .map(program -> List.of(program.toAbsolutePath().toString()))
        .orElse(IGNORING);
  }
}
