package org.dfra.examples.harness;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.behavior.Behavior;
import org.dfra.behavior.Goal;
import org.dfra.behavior.GoalRefusedException;

/** Submits goals to the robots of a demonstration, which have no other clients. */
public final class GoalSubmission {

  private GoalSubmission() {}

  /**
   * Submits a goal, once more if no answer comes. The robot may have begun although its answer was
   * late: then it refuses the second request as busy, with this goal, since nobody else gives it
   * one.
   *
   * @throws RemoteException if the second request is not answered either
   * @throws GoalRefusedException if the goal cannot be reached, or the robot was busy before
   */
  public static <G extends Goal> void submit(Behavior<G> robot, G goal) throws RemoteException {
    try {
      UUID unused = robot.pursue(goal);
    } catch (RemoteException e) {
      try {
        UUID unused = robot.pursue(goal);
      } catch (GoalRefusedException refusal) {
        if (!refusal.isBusy()) {
          throw refusal;
        }
      }
    }
  }
}
