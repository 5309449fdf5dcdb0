package org.dfra.cli.robot;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.river.bootstrap.DetachedCommand;
import org.dfra.river.bootstrap.JvmCommand;

/** Has the archive of classes written from which robots' processes start. */
final class ArchiveStart {

  /** By its name, since it needs all commands, and these would need it. */
  private static final String WRITER = "org.dfra.cli.archive.ArchiveWriter";

  /** If memory runs out, it ends before any process of a robot does. */
  private static final String LEAST_IMPORTANT =
      "echo 1000 2>/dev/null >/proc/self/oom_score_adj; nice -n 19 \"$@\" || exec \"$@\"";

  private static final String LIB = "dfra.lib";

  private ArchiveStart() {}

  /**
   * Starts the program that writes it, if it is missing. It runs in the background with the lowest
   * priority and outlives this process. Does nothing where no archives are kept.
   */
  static void startIfNeeded() {
    if (JvmCommand.archive().filter(each -> !each.isUsable()).isEmpty()) {
      return;
    }
    List<String> command = new ArrayList<>(DetachedCommand.prefix(System.getenv("PATH")));
    command.addAll(List.of("/bin/sh", "-c", LEAST_IMPORTANT, "sh"));
    command.add(JvmCommand.java());
    command.addAll(JvmCommand.options());
    command.add("-D" + LIB + "=" + System.getProperty(LIB, ""));
    command.add(WRITER);
    try {
      new ProcessBuilder(command)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .redirectError(ProcessBuilder.Redirect.DISCARD)
          .start()
          .getOutputStream()
          .close();
    } catch (IOException e) {
      // The robot is up. The next "up" tries again.
    }
  }
}
