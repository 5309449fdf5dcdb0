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
 * Phoenix's administration beyond River's original interface. The daemon's system proxy implements
 * it.
 */
public interface PhoenixAdmin extends ActivationAdmin {

  /** Returns the status of every registered group, in the order of registration. */
  List<GroupStatus> groupStatus() throws RemoteException;

  /**
   * Returns the active objects of a group. In an adopted group, an object counts as active until
   * phoenix has called the group for it.
   *
   * @throws ActivationException if there is no such group
   */
  List<ActivationID> activeObjects(ActivationGroupID group)
      throws ActivationException, RemoteException;

  /**
   * Returns the proxy of an active object, else null. Starts nothing, except in an adopted group
   * that has not been called for the object yet. Waits for a running instantiation.
   *
   * @throws ActivationException if there is no such object, or its instantiation takes too long
   */
  @Nullable MarshalledObject<? extends Remote> activeProxy(ActivationID object)
      throws ActivationException, RemoteException;

  /**
   * Unregisters an object, unless it is active. No call can instantiate it between the end of the
   * old one and its removal. Waits for a running instantiation.
   *
   * @return false, with nothing changed, if the object is active
   * @throws ActivationException if there is no such object, or its instantiation takes too long
   */
  boolean unregisterInactive(ActivationID object) throws ActivationException, RemoteException;
}
