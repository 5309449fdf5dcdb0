package org.dfra.river.bootstrap;

import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationSystem;
import org.dfra.river.phoenix.PhoenixAdmin;

/**
 * The remote interfaces of phoenix that the bootstrap uses; one proxy implements both.
 *
 * @param system registers and unregisters
 * @param admin reports the registered and the running services
 * @param state phoenix's state folder
 */
record PhoenixClient(ActivationSystem system, PhoenixAdmin admin, Path state) {

  /**
   * Nothing is sent before the first call.
   *
   * @throws RemoteException if this user may not call it, or phoenix was never started
   */
  static PhoenixClient to(PhoenixProcess phoenix) throws RemoteException {
    return new PhoenixClient(phoenix.system(), phoenix.admin(), phoenix.state());
  }
}
