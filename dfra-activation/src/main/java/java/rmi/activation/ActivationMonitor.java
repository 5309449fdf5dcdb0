package java.rmi.activation;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;

/**
 * The daemon's side that a group tells what became active or inactive in its JVM.
 *
 * <p>A group receives its monitor from {@link ActivationSystem#activeGroup}.
 */
public interface ActivationMonitor extends Remote {

  /**
   * An object went to sleep: the next call has to activate it anew.
   *
   * @param id whose object
   * @throws UnknownObjectException if it is not registered
   * @throws RemoteException if the call fails
   */
  void inactiveObject(ActivationID id) throws UnknownObjectException, RemoteException;

  /**
   * An object became active other than through {@link ActivationInstantiator#newInstance}.
   *
   * @param id whose object
   * @param obj its proxy, marshalled
   * @throws UnknownObjectException if it is not registered
   * @throws RemoteException if the call fails
   */
  void activeObject(ActivationID id, MarshalledObject<? extends Remote> obj)
      throws UnknownObjectException, RemoteException;

  /**
   * The group's JVM has nothing left to run: the next activation in it needs a new JVM.
   *
   * @param id which group
   * @param incarnation the number under which this JVM reported itself active
   * @throws UnknownGroupException if the group is not registered, or runs under another number
   * @throws RemoteException if the call fails
   */
  void inactiveGroup(ActivationGroupID id, long incarnation)
      throws UnknownGroupException, RemoteException;
}
