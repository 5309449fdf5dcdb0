package org.dfra.river.phoenix.stop;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.util.List;
import org.dfra.module.Idempotent;
import org.dfra.module.StopsRobot;
import org.jspecify.annotations.Nullable;

/**
 * Stops the effectors that phoenix runs on its computer, and has no other function. Phoenix exports
 * it under a well-known identity at its own port. Any client may call it, as any client may stop an
 * effector.
 */
public interface StopService extends Remote {

  /**
   * Stops the effectors for an emergency, see {@link
   * org.dfra.flow.effector.Effector#emergencyStop}. All groups receive the request at the same
   * time. A group that does not answer within about a second is reported as unconfirmed, and
   * executes the request when its process resumes. An effector that does not run is started, so
   * that it can be stopped; call again to confirm its stop.
   *
   * @param robots names of the robots whose effectors are stopped; all effectors of the computer if
   *     empty. Unknown names are ignored
   * @param by the requester, for people; as for an effector
   * @return the results
   */
  @Idempotent
  @StopsRobot
  StopReport emergencyStop(List<String> robots, @Nullable String by) throws RemoteException;
}
