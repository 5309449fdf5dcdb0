package org.dfra.river.bootstrap;

import java.nio.file.Path;
import java.util.Collection;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.core.effector.EmergencyStopLatch;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.EmergencyStopState;

/**
 * The effectors of this host with a latched emergency stop, from the stored states of their
 * modules. No module is called, so this works even if none answers.
 */
public final class StoredStopStates {

  private StoredStopStates() {}

  /**
   * The state of a module; {@link EmergencyStopState#NEVER} if it is no effector.
   *
   * @param state phoenix's state folder
   */
  public static EmergencyStopState of(Path state, String robot, String module) {
    return EmergencyStopLatch.loadState(
        StateStore.inFolder(RobotBootstrap.moduleStateFolder(state, robot, module)));
  }

  /**
   * The latched stops of a robot's modules, by module name.
   *
   * @param state phoenix's state folder
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
