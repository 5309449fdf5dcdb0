package org.dfra.river.bootstrap;

import java.nio.file.Path;
import java.util.Collection;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.core.effector.EmergencyStopLatch;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.EmergencyStopState;

/**
 * Which effectors of this host are stopped for an emergency, by what their modules have written
 * down: nobody is asked, so it is known too where nothing answers.
 */
public final class StoredStopStates {

  private StoredStopStates() {}

  /**
   * Of a module; {@link EmergencyStopState#NEVER} where it is no effector.
   *
   * @param state folder of what phoenix keeps
   */
  public static EmergencyStopState of(Path state, String robot, String module) {
    return EmergencyStopLatch.loadState(
        StateStore.inFolder(RobotBootstrap.moduleStateFolder(state, robot, module)));
  }

  /**
   * Those of a robot's modules that are stopped, by their names.
   *
   * @param state folder of what phoenix keeps
   */
  public static Map<String, EmergencyStopState> latched(
      Path state, String robot, Collection<String> modules) {
    Map<String, EmergencyStopState> latched = new TreeMap<>();
    for (String module : modules) {
      EmergencyStopState kept = of(state, robot, module);
      if (kept.latched()) {
        latched.put(module, kept);
      }
    }
    return latched;
  }
}
