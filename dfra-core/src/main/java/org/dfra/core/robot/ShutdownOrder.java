package org.dfra.core.robot;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.dfra.behavior.Behavior;
import org.dfra.flow.effector.Effector;

/**
 * The order in which the modules of a robot are closed: effectors, then behaviours, then all
 * others. Within each of the three, the module that was started last is closed first.
 *
 * <p>Effectors are first because nothing may move unsupervised. A closed effector refuses every
 * command, so a behaviour that still runs cannot move it again.
 */
public final class ShutdownOrder {

  private static final int OTHERS = 2;

  private ShutdownOrder() {}

  /**
   * Modules in the order in which they are closed.
   *
   * @param started drivers, servers or proxies of modules, in the order in which they were started
   */
  public static <T> List<T> of(Collection<? extends T> started) {
    List<T> ending = new ArrayList<>(started);
    Collections.reverse(ending);
    ending.sort(Comparator.comparingInt(ShutdownOrder::rank)); // stable
    return ending;
  }

  /**
   * Whether a module moves the robot: an effector, or a behaviour, which commands effectors. The
   * driver of such a module is closed before its other parts.
   *
   * @param module its driver, server or proxy
   */
  public static boolean movesRobot(Object module) {
    return rank(module) < OTHERS;
  }

  private static int rank(Object module) {
    if (module instanceof Effector) {
      return 0;
    }
    return module instanceof Behavior ? 1 : OTHERS;
  }
}
