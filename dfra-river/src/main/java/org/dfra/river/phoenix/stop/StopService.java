package org.dfra.river.phoenix.stop;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.util.List;
import org.dfra.module.Idempotent;
import org.jspecify.annotations.Nullable;

/**
 * Stops the effectors that phoenix runs on its computer, and can do nothing else. Phoenix exports
 * it under a well-known identity at its own port. Anybody may call it, as anybody may stop an
 * effector.
 */
public interface StopService extends Remote {

  /**
   * Stops the effectors for an emergency, see {@link
   * org.dfra.flow.effector.Effector#emergencyStop}. All groups are ordered at the same time; a
   * group that does not answer within about a second is reported as unconfirmed, and executes the
   * order when it goes on. An effector that does not run is started, so that it can be stopped;
   * call again to have it confirmed.
   *
   * @param robots names of the robots whose effectors are stopped; all effectors of the computer if
   *     empty. What is unknown is ignored
   * @param by who asks, for people; as for an effector
   * @return what has become of them
   */
  @Idempotent
  StopReport emergencyStop(List<String> robots, @Nullable String by) throws RemoteException;
}
