package org.dfra.core.behavior;

import java.rmi.RemoteException;
import org.dfra.lease.LeaseRefusedException;

/** The execution of one goal. Called by one thread at a time. */
public interface GoalExecution {

  /**
   * Executes one step; called at the behaviour's rate.
   *
   * @throws RemoteException if a module could not be reached: the behaviour stops, and the next
   *     cycle tries again; likewise for the others
   * @throws LeaseRefusedException if another client commands an effector; if it is in an
   *     {@linkplain org.dfra.flow.effector.RefusedByEmergencyStop emergency stop}, the goal is
   *     cancelled
   * @throws org.dfra.module.NotReadyException if a percept is missing or too old
   */
  GoalProgress step() throws RemoteException, LeaseRefusedException;

  /**
   * Suspends the execution: releases every effector, and stops delegated goals. The next {@link
   * #step}, if there is one, continues. May be called when suspended; must not throw.
   */
  void suspend();
}
