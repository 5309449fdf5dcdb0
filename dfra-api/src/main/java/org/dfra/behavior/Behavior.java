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
   * Takes up a goal for somebody who knows that the robot may move. It has begun to when the call
   * returns. Where the goal needs the robot's wheels, and their parking brake is set, this call
   * releases it; a brake that is set later is not released, and pauses the goal.
   *
   * @return names this pursuit in every {@link BehaviorStatus}
   * @throws GoalRefusedException if the goal cannot be reached, or another is being pursued
   * @throws org.dfra.module.NotReadyException if a module that it needs is not there
   */
  UUID pursue(G goal) throws RemoteException;

  /**
   * The same for a program that acts without a person, such as another behaviour: a parking brake
   * that is set stays set, and pauses the goal.
   */
  UUID pursueUnattended(G goal) throws RemoteException;

  /** How far it is. */
  @Idempotent
  BehaviorStatus status() throws RemoteException;

  /**
   * Stands still and keeps the goal, for a person. From then on only {@link #resume} has it go on,
   * also where a program had paused it before.
   */
  @Idempotent
  void pause() throws RemoteException;

  /**
   * The same for a program that acts without a person and means to have it go on by {@link
   * #resumeUnattended}. Does nothing unless it runs.
   */
  @Idempotent
  void pauseUnattended() throws RemoteException;

  /**
   * Goes on after a pause, for somebody who knows that the robot may move: releases the parking
   * brake as {@link #pursue} does. Does nothing unless it is paused.
   */
  @Idempotent
  void resume() throws RemoteException;

  /**
   * Goes on after {@link #pauseUnattended}; a parking brake that is set stays set. Does nothing
   * where it is paused for another reason, such as a brake, or where somebody has called {@link
   * #pause} since, or its process is another one since.
   */
  @Idempotent
  void resumeUnattended() throws RemoteException;

  /** Stands still and gives the goal up. Does nothing unless one is being pursued. */
  @Idempotent
  void cancel() throws RemoteException;

  /**
   * Gives up this goal, and no other: does nothing where another has been taken up since.
   *
   * @param goal as {@link #pursue} has named it
   */
  @Idempotent
  void cancel(UUID goal) throws RemoteException;

  /**
   * The same for a program that acts without a person, such as the behaviour that began the goal:
   * the goal does not become {@linkplain BehaviorStatus#heldSince held} by it, and stays held where
   * somebody has stopped it before.
   */
  @Idempotent
  void cancelUnattended(UUID goal) throws RemoteException;
}
