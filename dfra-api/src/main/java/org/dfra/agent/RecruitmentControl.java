package org.dfra.agent;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;
import org.dfra.module.Module;

/** The interface of a recruitment agent for its robot's operators and other modules. */
public interface RecruitmentControl extends Module {

  /**
   * Calls for help. {@link #status} and its readings report the progress.
   *
   * @throws HelpCallRejectedException if no reachable robot can observe the percept, the place is
   *     outside the field, or a call is in progress; nothing was sent
   * @throws org.dfra.module.NotReadyException if the agent is not ready
   */
  void callForHelp(HelpCall call) throws RemoteException;

  /** Cancels the call, and releases the helper. Does nothing if there is no call. */
  @Idempotent
  void release() throws RemoteException;

  /**
   * Lets a robot that is {@linkplain RecruitmentStatus#holdReason held} answer calls for help
   * again. An operator calls this who knows that the robot may move. The call itself moves nothing,
   * and what is paused stays paused. It does not end an emergency stop: a robot that is stopped
   * stays held.
   */
  @Idempotent
  void resume() throws RemoteException;

  /** The agent's current state. */
  @Idempotent
  RecruitmentStatus status() throws RemoteException;
}
