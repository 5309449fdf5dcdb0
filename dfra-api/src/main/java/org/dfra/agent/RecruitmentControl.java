package org.dfra.agent;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;
import org.dfra.module.Module;

/** What a robot's operators and its other modules ask of its recruitment agent. */
public interface RecruitmentControl extends Module {

  /**
   * Calls for help. How it goes on, {@link #status} and its readings tell.
   *
   * @throws HelpCallRejectedException if nobody in reach can observe the percept, the place is
   *     outside the field, or a call is under way; nothing was sent
   * @throws org.dfra.module.NotReadyException if the agent does not serve
   */
  void callForHelp(HelpCall call) throws RemoteException;

  /** Gives the call up, and lets the helper go. Does nothing where there is none. */
  @Idempotent
  void release() throws RemoteException;

  /**
   * Has a robot that is {@linkplain RecruitmentStatus#holdReason held} answer calls for help again,
   * for somebody who knows that it may move. Nothing moves by this, and what is paused stays
   * paused. It does not end an emergency stop: a robot that is stopped stays held.
   */
  @Idempotent
  void resume() throws RemoteException;

  /** What it is at. */
  @Idempotent
  RecruitmentStatus status() throws RemoteException;
}
