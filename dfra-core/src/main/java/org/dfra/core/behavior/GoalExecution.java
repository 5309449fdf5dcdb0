package org.dfra.core.behavior;

import java.rmi.RemoteException;
import org.dfra.lease.LeaseRefusedException;

/** One goal being pursued. It is asked by one thread at a time. */
public interface GoalExecution {

  /**
   * Does what is to be done now; called at the behaviour's rate.
   *
   * @throws RemoteException if a module could not be reached: the behaviour comes to rest, and the
   *     next turn tries again; likewise
   * @throws LeaseRefusedException if somebody else commands an effector; where it is {@linkplain
   *     org.dfra.flow.effector.RefusedByEmergencyStop stopped for an emergency}, the goal is
   *     cancelled
   * @throws org.dfra.module.NotReadyException if a percept is missing or too old
   */
  GoalProgress step() throws RemoteException, LeaseRefusedException;

  /**
   * Comes to rest: lets go of every effector, and has others that work for it stop. The next {@link
   * #step}, if there is one, goes on. May be called when at rest; must not throw.
   */
  void suspend();
}
