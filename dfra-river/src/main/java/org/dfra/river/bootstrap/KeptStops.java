package org.dfra.river.bootstrap;

import java.nio.file.Path;
import java.util.Collection;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.core.effector.StopLatch;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.StopState;

/**
 * Which effectors of this host are stopped for an emergency, by what their modules have written
 * down: nobody is asked, so it is known too where nothing answers.
 */
public final class KeptStops {

  private KeptStops() {}

  /**
   * Of a module; {@link StopState#NEVER} where it is no effector.
   *
   * @param state folder of what phoenix keeps
   */
  public static StopState of(Path state, String robot, String module) {
    return StopLatch.kept(StateStore.in(RobotBootstrap.folder(state, robot, module)));
  }

  /**
   * Those of a robot's modules that are stopped, by their names.
   *
   * @param state folder of what phoenix keeps
   */
  public static Map<String, StopState> latched(
      Path state, String robot, Collection<String> modules) {
    Map<String, StopState> latched = new TreeMap<>();
    for (String module : modules) {
      StopState kept = of(state, robot, module);
      if (kept.latched()) {
        latched.put(module, kept);
      }
    }
    return latched;
  }
}
