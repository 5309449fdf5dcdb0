package org.dfra.behavior;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.Schema;
import org.dfra.module.Idempotent;

/**
 * A module that pursues goals, one at a time. It publishes its progress to its listeners as {@link
 * BehaviorStatus}.
 *
 * @param <G> the goals that it can pursue
 */
public interface Behavior<G extends Goal> extends Schema {

  /**
   * Starts a goal for an operator who knows that the robot may move. The goal has started when the
   * call returns. If the goal needs the robot's wheels and their parking brake is set, this call
   * releases the brake. A brake that is set later is not released, and pauses the goal.
   *
   * @return the goal's identity in every {@link BehaviorStatus}
   * @throws GoalRefusedException if the goal cannot be reached, or another is in progress
   * @throws org.dfra.module.NotReadyException if a required module is not available
   */
  UUID pursue(G goal) throws RemoteException;

  /**
   * Does the same for a program that acts without an operator, such as another behaviour: a parking
   * brake that is set stays set, and pauses the goal.
   */
  UUID pursueUnattended(G goal) throws RemoteException;

  /** The current status. */
  @Idempotent
  BehaviorStatus status() throws RemoteException;

  /**
   * Stops the robot and keeps the goal, for an operator. Only {@link #resume} then continues the
   * goal, even if a program had paused it before.
   */
  @Idempotent
  void pause() throws RemoteException;

  /**
   * Does the same for a program that acts without an operator and continues the goal by {@link
   * #resumeUnattended}. Does nothing unless the goal is running.
   */
  @Idempotent
  void pauseUnattended() throws RemoteException;

  /**
   * Resumes after a pause, for an operator who knows that the robot may move: releases the parking
   * brake as {@link #pursue} does. Does nothing unless the goal is paused.
   */
  @Idempotent
  void resume() throws RemoteException;

  /**
   * Resumes after {@link #pauseUnattended}; a parking brake that is set stays set. Does nothing if
   * the goal is paused for another reason, such as a brake, or if {@link #pause} was called or the
   * process was restarted in the meantime.
   */
  @Idempotent
  void resumeUnattended() throws RemoteException;

  /** Stops the robot and cancels the goal. Does nothing unless a goal is in progress. */
  @Idempotent
  void cancel() throws RemoteException;

  /**
   * Cancels only this goal: does nothing if another has been started since.
   *
   * @param goal the identity that {@link #pursue} returned
   */
  @Idempotent
  void cancel(UUID goal) throws RemoteException;

  /**
   * Does the same for a program that acts without an operator, such as the behaviour that started
   * the goal. The goal does not become {@linkplain BehaviorStatus#heldSince held} by it, and stays
   * held if an operator stopped it before.
   */
  @Idempotent
  void cancelUnattended(UUID goal) throws RemoteException;
}
