package java.rmi.activation;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;

/**
 * The daemon's remote interface to which a group reports what became active or inactive in its JVM.
 *
 * <p>A group receives its monitor from {@link ActivationSystem#activeGroup}.
 */
public interface ActivationMonitor extends Remote {

  /**
   * Reports that an object became inactive: the next call has to activate it again.
   *
   * @param id whose object
   * @throws UnknownObjectException if it is not registered
   * @throws RemoteException if the call fails
   */
  void inactiveObject(ActivationID id) throws UnknownObjectException, RemoteException;

  /**
   * Reports that an object became active other than through {@link
   * ActivationInstantiator#newInstance}.
   *
   * @param id whose object
   * @param obj its proxy, marshalled
   * @throws UnknownObjectException if it is not registered
   * @throws RemoteException if the call fails
   */
  void activeObject(ActivationID id, MarshalledObject<? extends Remote> obj)
      throws UnknownObjectException, RemoteException;

  /**
   * Reports that the group's JVM has no active objects left: the group's next activation needs a
   * new JVM.
   *
   * @param id the group
   * @param incarnation the number under which this JVM reported itself active
   * @throws UnknownGroupException if the group is not registered, or runs under another number
   * @throws RemoteException if the call fails
   */
  void inactiveGroup(ActivationGroupID id, long incarnation)
      throws UnknownGroupException, RemoteException;
}
