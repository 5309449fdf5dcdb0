package org.dfra.river.phoenix.stop;

import java.rmi.Remote;
import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** Stops the effectors in the virtual machine of a group. The proxy of its instantiator has it. */
public interface GroupStop extends Remote {

  /**
   * Stops all of them, at the same time. One that is being made is stopped when it is made, and not
   * awaited. Takes a second at the most.
   *
   * @param by who asks, for people
   * @return what each answered
   */
  @Idempotent
  GroupStopResult emergencyStop(String by) throws RemoteException;
}
