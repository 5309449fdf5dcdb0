package org.dfra.behavior;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.UUID;

/** Drives a robot along a line to its end, around obstacles. */
public interface GoToWaypoint extends Behavior<LegGoal> {

  /**
   * Changes the {@linkplain LegGoal#timeLimit time limit} of a goal in progress without stopping
   * the robot. Does nothing if another goal or none is in progress.
   *
   * @param goal the identity that {@link #pursue} returned
   * @param limit the goal fails after this time from now, by the clock of the behaviour
   * @throws IllegalArgumentException if it is below 0
   */
  void setTimeLimit(UUID goal, Duration limit) throws RemoteException;
}
