package org.dfra.behavior;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.Schema;
import org.dfra.module.Idempotent;

/**
 * A module that reaches goals, one at a time. What it does meanwhile it tells its listeners as
 * {@link BehaviorStatus}.
 *
 * @param <G> what it can reach
 */
public interface Behavior<G extends Goal> extends Schema {

  /**
   * Takes up a goal. It has begun to when the call returns.
   *
   * @return names this pursuit in every {@link BehaviorStatus}
   * @throws GoalRefusedException if the goal cannot be reached, or another is being pursued
   * @throws org.dfra.module.NotReadyException if a module that it needs is not there
   */
  UUID pursue(G goal) throws RemoteException;

  /** How far it is. */
  @Idempotent
  BehaviorStatus status() throws RemoteException;

  /** Stands still and keeps the goal. Does nothing unless it runs. */
  @Idempotent
  void pause() throws RemoteException;

  /** Goes on after {@link #pause}. Does nothing unless it is paused. */
  @Idempotent
  void resume() throws RemoteException;

  /** Stands still and gives the goal up. Does nothing unless one is being pursued. */
  @Idempotent
  void cancel() throws RemoteException;
}
