package java.rmi.activation;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;

/**
 * The daemon's remote interface that clients call, through {@link ActivationID#activate}, to start
 * objects.
 */
public interface Activator extends Remote {

  /**
   * Starts an object if it is not running, and returns its proxy.
   *
   * @param id whose object
   * @param force false: the proxy of an earlier activation may be returned; true: that proxy
   *     failed, so the activator asks the object's group
   * @return the object's proxy, marshalled by its group
   * @throws ActivationException if the object or its group cannot be started
   * @throws UnknownObjectException if the object is not registered here
   * @throws RemoteException if the call fails
   */
  MarshalledObject<? extends Remote> activate(ActivationID id, boolean force)
      throws ActivationException, UnknownObjectException, RemoteException;
}
