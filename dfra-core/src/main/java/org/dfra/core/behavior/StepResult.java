package org.dfra.core.behavior;

import java.rmi.RemoteException;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.RefusedByEmergencyStop;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.NotReadyException;

/** The result of one step of a goal, including any exception. */
sealed interface StepResult {

  /** The step was executed. */
  record Advanced(GoalProgress progress) implements StepResult {}

  /** A module or percept is missing; the next step tries again. */
  record Waiting(Exception reason) implements StepResult {

    /** One line: a failed call's message lists its causes on further lines. */
    String inWords() {
      String message = String.valueOf(reason.getMessage());
      boolean isCall = reason instanceof RemoteException && reason.getCause() != null;
      int nested = message.indexOf("; nested exception is:");
      return isCall && nested > 0 ? "a call failed: " + message.substring(0, nested) : message;
    }
  }

  /**
   * The robot was stopped, so that only a new request may move it.
   *
   * @param phase the goal's new phase
   */
  record Stopped(Phase phase, String why) implements StepResult {}

  /** The behaviour is faulty; the robot must not drive on. */
  record Faulty(Throwable fault) implements StepResult {}

  /** Executes the next step of a goal. */
  static StepResult ofNextStep(GoalExecution execution) {
    try {
      return new Advanced(execution.step());
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
