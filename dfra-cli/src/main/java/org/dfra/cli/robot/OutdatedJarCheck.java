package org.dfra.cli.robot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.dfra.cli.team.PhoenixOptions;
import org.dfra.core.host.CommandName;
import org.dfra.river.bootstrap.PhoenixInventory;
import org.dfra.river.bootstrap.PhoenixInventory.ServiceGroup;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.jspecify.annotations.Nullable;

/**
 * Finds service groups that were started from other jars than this command, such as an older
 * build's.
 */
final class OutdatedJarCheck {

  private OutdatedJarCheck() {}

  /**
   * A sentence for each group of a robot that runs from other jars.
   *
   * @param robot name of the robot
   * @param alreadyReported names of groups that were reported before
   */
  static List<String> warnings(PhoenixProcess phoenix, String robot, Set<String> alreadyReported)
      throws IOException, ActivationException {
    @Nullable String lib = System.getProperty("dfra.lib");
    List<String> sentences = new ArrayList<>();
    if (lib != null) {
      for (ServiceGroup each : PhoenixInventory.groups(phoenix, PhoenixOptions.TIMEOUT)) {
        if (each.robot().equals(robot)
            && !alreadyReported.contains(each.name())
            && runsFromOther(Path.of("/proc"), each.status().pid(), lib)) {
          sentences.add(
              "Group "
                  + each.name()
                  + " still runs from the jars that it was started with; to have it take the new"
                  + " ones: "
                  + CommandName.current()
                  + " down "
                  + robot
                  + ", then up");
        }
      }
    }
    return sentences;
  }

  /**
   * Whether a process runs from other jars than those in a folder; false if unknown.
   *
   * @param proc the folder {@code /proc}
   */
  static boolean runsFromOther(Path proc, long pid, String lib) {
    Path command = proc.resolve(Long.toString(pid)).resolve("cmdline");
    try {
      return pid > 0 && !Files.readString(command).contains(lib + "/");
    } catch (IOException e) { // it has exited, or the system has no such file
      return false;
    }
  }
}
