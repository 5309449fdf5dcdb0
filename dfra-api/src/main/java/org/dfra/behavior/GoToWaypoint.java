package org.dfra.behavior;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.UUID;

/** Drives a robot along a line to its end, around what is in the way. */
public interface GoToWaypoint extends Behavior<LegGoal> {

  /**
   * Gives a goal that is being pursued another {@linkplain LegGoal#timeLimit time limit}; the robot
   * drives on meanwhile. Does nothing where another goal is pursued, or none.
   *
   * @param goal as {@link #pursue} has named it
   * @param limit the goal has failed when this has passed from now on, by the clock of the
   *     behaviour
   * @throws IllegalArgumentException if it is below 0
   */
  void setTimeLimit(UUID goal, Duration limit) throws RemoteException;
}
