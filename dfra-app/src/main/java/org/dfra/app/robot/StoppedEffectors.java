package org.dfra.app.robot;

import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import org.dfra.river.bootstrap.StoredStopStates;

/** The emergency stops of this host's effectors, as text. */
final class StoppedEffectors {

  private StoppedEffectors() {}

  /**
   * A sentence with the remedy for each of a robot's modules in emergency stop.
   *
   * @param state phoenix's state folder
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
