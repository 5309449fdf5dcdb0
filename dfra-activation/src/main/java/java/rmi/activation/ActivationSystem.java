package java.rmi.activation;

import java.rmi.Remote;
import java.rmi.RemoteException;

/**
 * The daemon's side with which groups and objects are registered.
 *
 * <p>It keeps descriptors, so that a JVM can be started again after a crash. Every method throws
 * {@link RemoteException} if the call fails.
 */
public interface ActivationSystem extends Remote {

  /** The TCP port of the registry in which the local system is bound, unless configured. */
  int SYSTEM_PORT = 1098;

  /**
   * Registers an activatable object.
   *
   * @param desc its group, class, location, data and restart mode
   * @return its identity from now on
   * @throws ActivationException if it cannot be registered
   * @throws UnknownGroupException if its group is not registered
   * @throws RemoteException if the call fails
   */
  ActivationID registerObject(ActivationDesc desc)
      throws ActivationException, UnknownGroupException, RemoteException;

  /**
   * Forgets an object; it can no longer be activated.
   *
   * @param id whose object
   * @throws ActivationException if it cannot be unregistered
   * @throws UnknownObjectException if it is not registered
   * @throws RemoteException if the call fails
   */
  void unregisterObject(ActivationID id)
      throws ActivationException, UnknownObjectException, RemoteException;

  /**
   * Registers a group, that is: how its JVM is started.
   *
   * @param desc the group's class, data, properties and command
   * @return the group's identity from now on
   * @throws ActivationException if it cannot be registered
   * @throws RemoteException if the call fails
   */
  ActivationGroupID registerGroup(ActivationGroupDesc desc)
      throws ActivationException, RemoteException;

  /**
   * The group reports from its JVM that it is ready to construct objects.
   *
   * @param id which group
   * @param group how to reach it
   * @param incarnation the number given to this JVM when it was started
   * @return whom the group tells of its objects
   * @throws UnknownGroupException if the group is not registered
   * @throws ActivationException if it is active already
   * @throws RemoteException if the call fails
   */
  ActivationMonitor activeGroup(
      ActivationGroupID id, ActivationInstantiator group, long incarnation)
      throws UnknownGroupException, ActivationException, RemoteException;

  /**
   * Forgets a group and every object in it.
   *
   * @param id which group
   * @throws ActivationException if it cannot be unregistered
   * @throws UnknownGroupException if it is not registered
   * @throws RemoteException if the call fails
   */
  void unregisterGroup(ActivationGroupID id)
      throws ActivationException, UnknownGroupException, RemoteException;

  /**
   * Ends the daemon and every group's JVM it started.
   *
   * @throws RemoteException if the call fails
   */
  void shutdown() throws RemoteException;

  /**
   * Replaces an object's descriptor; used from its next activation on.
   *
   * @param id whose object
   * @param desc the new descriptor
   * @return the one before
   * @throws ActivationException if it cannot be replaced
   * @throws UnknownObjectException if the object is not registered
   * @throws UnknownGroupException if the descriptor's group is not registered
   * @throws RemoteException if the call fails
   */
  ActivationDesc setActivationDesc(ActivationID id, ActivationDesc desc)
      throws ActivationException, UnknownObjectException, UnknownGroupException, RemoteException;

  /**
   * Replaces a group's descriptor; used from the next start of its JVM on.
   *
   * @param id which group
   * @param desc the new descriptor
   * @return the one before
   * @throws ActivationException if it cannot be replaced
   * @throws UnknownGroupException if the group is not registered
   * @throws RemoteException if the call fails
   */
  ActivationGroupDesc setActivationGroupDesc(ActivationGroupID id, ActivationGroupDesc desc)
      throws ActivationException, UnknownGroupException, RemoteException;

  /**
   * An object's descriptor.
   *
   * @param id whose object
   * @return what it is registered with
   * @throws ActivationException if it cannot be told
   * @throws UnknownObjectException if the object is not registered
   * @throws RemoteException if the call fails
   */
  ActivationDesc getActivationDesc(ActivationID id)
      throws ActivationException, UnknownObjectException, RemoteException;

  /**
   * A group's descriptor.
   *
   * @param id which group
   * @return what it is registered with
   * @throws ActivationException if it cannot be told
   * @throws UnknownGroupException if the group is not registered
   * @throws RemoteException if the call fails
   */
  ActivationGroupDesc getActivationGroupDesc(ActivationGroupID id)
      throws ActivationException, UnknownGroupException, RemoteException;
}
