package org.dfra.core.behavior;

import java.rmi.RemoteException;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.RefusedByEmergencyStop;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.NotReadyException;

/** What one step of a goal's pursuit has come to, whatever it has thrown. */
sealed interface StepResult {

  /** It has done what was to be done. */
  record Advanced(GoalProgress progress) implements StepResult {}

  /** Something is missing, and the next step tries again. */
  record Waiting(Exception reason) implements StepResult {

    /** One line: a call that failed tells of its causes on lines of their own. */
    String inWords() {
      String message = String.valueOf(reason.getMessage());
      boolean isCall = reason instanceof RemoteException && reason.getCause() != null;
      int nested = message.indexOf("; nested exception is:");
      return isCall && nested > 0 ? "a call failed: " + message.substring(0, nested) : message;
    }
  }

  /**
   * Somebody has stopped the robot, so that nothing may move it but a new request.
   *
   * @param phase in which the goal is now
   */
  record Stopped(Phase phase, String why) implements StepResult {}

  /** The behaviour is faulty; the robot must not drive on. */
  record Faulty(Throwable fault) implements StepResult {}

  /** Has a pursuit make one step. */
  static StepResult ofNextStep(GoalExecution pursuit) {
    try {
      return new Advanced(pursuit.step());
    } catch (NotReadyException
        | CommandRefusedException
        | LeaseRefusedException
        | RemoteException e) {
      if (e instanceof RefusedByEmergencyStop) { // its release must not move the robot
        return new Stopped(Phase.CANCELLED, String.valueOf(e.getMessage()));
      } else if (e instanceof BrakeEngagedException) { // likewise
        return new Stopped(Phase.PAUSED, e.getMessage() + "; when it may move, resume the goal");
      }
      return new Waiting(e);
    } catch (DelegateHeldException e) {
      return new Stopped(Phase.PAUSED, e.getMessage() + "; when it may move, resume the goal");
    } catch (GoalRefusedException e) {
      return e.isBusy() ? new Waiting(e) : new Faulty(e);
    } catch (RuntimeException | Error e) {
      return new Faulty(e);
    }
  }
}
