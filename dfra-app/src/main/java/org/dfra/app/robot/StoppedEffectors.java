package org.dfra.app.robot;

import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import org.dfra.river.bootstrap.StoredStopStates;

/** The emergency stops of this host's effectors, for people. */
final class StoppedEffectors {

  private StoppedEffectors() {}

  /**
   * Of those of a robot's modules that are stopped, a sentence each with the remedy.
   *
   * @param state folder of what phoenix keeps
   */
  static List<String> notices(Path state, String robot, Collection<String> modules) {
    return StoredStopStates.latched(state, robot, modules).entrySet().stream()
        .map(
            each ->
                robot
                    + "/"
                    + each.getKey()
                    + " is stopped for an emergency "
                    + each.getValue().inWords()
                    + "; when it is safe: ./dfra stop --release "
                    + robot)
        .toList();
  }
}
