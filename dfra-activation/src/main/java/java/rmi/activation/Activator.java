package java.rmi.activation;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;

/** The daemon's side that clients call, through {@link ActivationID#activate}, to start objects. */
public interface Activator extends Remote {

  /**
   * Makes sure that an object is running, and says how to reach it.
   *
   * @param id whose object
   * @param force false: the proxy known from an earlier activation will do; true: the caller found
   *     that proxy dead, so ask the object's group
   * @return the object's proxy, marshalled by its group
   * @throws ActivationException if the object or its group cannot be started
   * @throws UnknownObjectException if the object is not registered here
   * @throws RemoteException if the call fails
   */
  MarshalledObject<? extends Remote> activate(ActivationID id, boolean force)
      throws ActivationException, UnknownObjectException, RemoteException;
}
