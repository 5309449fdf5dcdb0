package org.dfra.river.phoenix.stop;

import java.rmi.Remote;
import java.rmi.RemoteException;
import org.dfra.module.Idempotent;
import org.dfra.module.StopsRobot;

/**
 * Stops the effectors in a group's virtual machine. The proxy of its instantiator implements it.
 */
public interface StoppableGroup extends Remote {

  /**
   * Stops all effectors at the same time. An effector that is being instantiated is stopped after
   * that, and not awaited. Takes at most a second.
   *
   * @param by the requester, for people
   * @return the answer of each
   */
  @Idempotent
  @StopsRobot
  GroupStopResult emergencyStop(String by) throws RemoteException;
}
