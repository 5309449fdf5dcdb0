package java.rmi.activation;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;

/**
 * The group's remote interface, which the daemon calls to construct an object in the group's JVM.
 */
public interface ActivationInstantiator extends Remote {

  /**
   * Constructs the object, or finds it already running.
   *
   * <p>Its class is loaded from the descriptor's location and needs a constructor {@code
   * (ActivationID, MarshalledObject)}, which may be non-public.
   *
   * @param id the object's identity, given to its constructor
   * @param desc class, location and initialisation data
   * @return the object's proxy, marshalled
   * @throws ActivationException if the object cannot be constructed
   * @throws RemoteException if the call fails
   */
  MarshalledObject<? extends Remote> newInstance(ActivationID id, ActivationDesc desc)
      throws ActivationException, RemoteException;
}
