package java.rmi.activation;

import java.rmi.Remote;
import java.rmi.RemoteException;

/**
 * The daemon's remote interface with which groups and objects are registered.
 *
 * <p>It stores descriptors, so that a JVM can be started again after a crash. Every method throws
 * {@link RemoteException} if the call fails.
 */
public interface ActivationSystem extends Remote {

  /** The TCP port of the registry in which the local system is bound by default. */
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
   * Unregisters an object; it can no longer be activated.
   *
   * @param id whose object
   * @throws ActivationException if it cannot be unregistered
   * @throws UnknownObjectException if it is not registered
   * @throws RemoteException if the call fails
   */
  void unregisterObject(ActivationID id)
      throws ActivationException, UnknownObjectException, RemoteException;

  /**
   * Registers a group, with the descriptor that its JVM is started from.
   *
   * @param desc the group's class, data, properties and command
   * @return the group's identity from now on
   * @throws ActivationException if it cannot be registered
   * @throws RemoteException if the call fails
   */
  ActivationGroupID registerGroup(ActivationGroupDesc desc)
      throws ActivationException, RemoteException;

  /**
   * Reports that a group's JVM is ready to construct objects.
   *
   * @param id the group
   * @param group its remote reference
   * @param incarnation the number given to this JVM when it was started
   * @return the monitor to which the group reports its objects
   * @throws UnknownGroupException if the group is not registered
   * @throws ActivationException if it is active already
   * @throws RemoteException if the call fails
   */
  ActivationMonitor activeGroup(
      ActivationGroupID id, ActivationInstantiator group, long incarnation)
      throws UnknownGroupException, ActivationException, RemoteException;

  /**
   * Unregisters a group and every object in it.
   *
   * @param id the group
   * @throws ActivationException if it cannot be unregistered
   * @throws UnknownGroupException if it is not registered
   * @throws RemoteException if the call fails
   */
  void unregisterGroup(ActivationGroupID id)
      throws ActivationException, UnknownGroupException, RemoteException;

  /**
   * Shuts down the daemon and every group's JVM that it started.
   *
   * @throws RemoteException if the call fails
   */
  void shutdown() throws RemoteException;

  /**
   * Replaces an object's descriptor; used from its next activation on.
   *
   * @param id whose object
   * @param desc the new descriptor
   * @return the previous descriptor
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
   * @param id the group
   * @param desc the new descriptor
   * @return the previous descriptor
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
   * @return the descriptor that it is registered with
   * @throws ActivationException if it cannot be returned
   * @throws UnknownObjectException if the object is not registered
   * @throws RemoteException if the call fails
   */
  ActivationDesc getActivationDesc(ActivationID id)
      throws ActivationException, UnknownObjectException, RemoteException;

  /**
   * A group's descriptor.
   *
   * @param id the group
   * @return the descriptor that it is registered with
   * @throws ActivationException if it cannot be returned
   * @throws UnknownGroupException if the group is not registered
   * @throws RemoteException if the call fails
   */
  ActivationGroupDesc getActivationGroupDesc(ActivationGroupID id)
      throws ActivationException, UnknownGroupException, RemoteException;
}
