package org.dfra.river.phoenix;

import com.sun.jini.phoenix.ActivationAdmin;
import java.rmi.RemoteException;
import java.util.List;

/**
 * What an administrator can ask of phoenix, beyond what the original offers. The daemon's system
 * proxy implements it.
 */
public interface PhoenixAdmin extends ActivationAdmin {

  /** Every registered group, in the order of registration. */
  List<GroupStatus> groupStatus() throws RemoteException;
}
