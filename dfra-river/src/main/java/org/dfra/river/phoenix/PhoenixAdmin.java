package org.dfra.river.phoenix;

import com.sun.jini.phoenix.ActivationAdmin;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What an administrator can ask of phoenix, beyond what the original offers. The daemon's system
 * proxy implements it.
 */
public interface PhoenixAdmin extends ActivationAdmin {

  /** Every registered group, in the order of registration. */
  List<GroupStatus> groupStatus() throws RemoteException;

  /**
   * Those objects of a group that are active. In a group that a restarted phoenix took back, an
   * object counts as active until the group was asked for it.
   *
   * @throws ActivationException if there is no such group
   */
  List<ActivationID> activeObjects(ActivationGroupID group)
      throws ActivationException, RemoteException;

  /**
   * The proxy of an object that is active; null where it is not. Nothing is started, except in a
   * group that a restarted phoenix took back and that was not asked for the object yet. An object
   * that is being made is awaited.
   *
   * @throws ActivationException if there is no such object, or it takes too long to be made
   */
  @Nullable MarshalledObject<? extends Remote> activeProxy(ActivationID object)
      throws ActivationException, RemoteException;

  /**
   * Unregisters an object, unless it is active: so nobody has it made between the end of the old
   * one and its being forgotten. An object that is being made is awaited.
   *
   * @return false, with nothing changed, if the object is active
   * @throws ActivationException if there is no such object, or it takes too long to be made
   */
  boolean unregisterInactive(ActivationID object) throws ActivationException, RemoteException;
}
