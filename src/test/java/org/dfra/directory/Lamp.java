package org.dfra.directory;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;
import org.dfra.module.Module;

/** A module that can be commanded. */
interface Lamp extends Module {

  /** A command: never repeated. */
  void toggle() throws RemoteException;

  /** A question. */
  @Idempotent
  String who() throws RemoteException;
}
