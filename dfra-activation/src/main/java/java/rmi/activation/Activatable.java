package java.rmi.activation;

import java.net.MalformedURLException;
import java.rmi.MarshalledObject;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.server.RMIClassLoader;
import java.rmi.server.RMIClientSocketFactory;
import java.rmi.server.RMIServerSocketFactory;
import java.rmi.server.RemoteServer;
import java.rmi.server.UnicastRemoteObject;

/**
 * Activatable objects over JRMP: a base class, and methods for objects with another base class.
 *
 * <p>{@link #register} and {@link #exportObject(Remote, ActivationID, int)} return proxies that
 * activate the object when it is not running. They differ from the former JDK's in one point: an
 * exported object that is itself passed in a remote call is replaced by the plain stub of its
 * current instance, which does not activate. Pass on the returned proxies instead.
 *
 * <p>Apache River's JERI services do not need this class; its JrmpExporter does.
 */
public abstract class Activatable extends RemoteServer {

  private static final long serialVersionUID = -3120617863591563455L;

  /**
   * @serial the object's identity
   */
  private final ActivationID id;

  /**
   * Registers this object in this JVM's group, exports it and reports it active.
   *
   * @param location the codebase of its class: URLs separated by spaces, or null
   * @param data the argument of its constructor when it is activated again, or null
   * @param restart true: activated when the daemon starts and after a crash; false: on demand only
   * @param port the TCP port, 0 for any
   * @throws ActivationException if this JVM has no group, or the system refuses
   * @throws RemoteException if it cannot be exported, or the daemon cannot be reached
   */
  protected Activatable(String location, MarshalledObject<?> data, boolean restart, int port)
      throws ActivationException, RemoteException {
    this(location, data, restart, port, null, null);
  }

  /**
   * Registers this object in this JVM's group, exports it and reports it active.
   *
   * @param location the codebase of its class: URLs separated by spaces, or null
   * @param data the argument of its constructor when it is activated again, or null
   * @param restart true: activated when the daemon starts and after a crash; false: on demand only
   * @param port the TCP port, 0 for any
   * @param csf makes the clients' sockets, or null for plain ones
   * @param ssf makes the server's sockets, or null for plain ones
   * @throws ActivationException if this JVM has no group, or the system refuses
   * @throws RemoteException if it cannot be exported, or the daemon cannot be reached
   */
  protected Activatable(
      String location,
      MarshalledObject<?> data,
      boolean restart,
      int port,
      RMIClientSocketFactory csf,
      RMIServerSocketFactory ssf)
      throws ActivationException, RemoteException {
    id = exportObject(this, location, data, restart, port, csf, ssf);
  }

  /**
   * Exports this object, registered before; for the constructor that the group calls.
   *
   * @param id its identity
   * @param port the TCP port, 0 for any
   * @throws RemoteException if it cannot be exported
   */
  protected Activatable(ActivationID id, int port) throws RemoteException {
    this(id, port, null, null);
  }

  /**
   * Exports this object, registered before; for the constructor that the group calls.
   *
   * @param id its identity
   * @param port the TCP port, 0 for any
   * @param csf makes the clients' sockets, or null for plain ones
   * @param ssf makes the server's sockets, or null for plain ones
   * @throws RemoteException if it cannot be exported
   */
  protected Activatable(
      ActivationID id, int port, RMIClientSocketFactory csf, RMIServerSocketFactory ssf)
      throws RemoteException {
    this.id = id;
    exportObject(this, id, port, csf, ssf);
  }

  /**
   * The identity under which the daemon knows this object.
   *
   * @return its identity
   */
  protected ActivationID getID() {
    return id;
  }

  /**
   * Registers an object without constructing it.
   *
   * @param desc how it is constructed; its class is loaded here, for its remote interfaces
   * @return a proxy with these interfaces; the first call activates the object
   * @throws UnknownGroupException if the descriptor's group is not registered
   * @throws ActivationException if there is no system, it refuses, or the class cannot be loaded or
   *     has no remote interface; then the object is not registered
   * @throws RemoteException if the daemon cannot be reached
   */
  public static Remote register(ActivationDesc desc)
      throws UnknownGroupException, ActivationException, RemoteException {
    Class<?> implementation;
    try {
      implementation = RMIClassLoader.loadClass(desc.getLocation(), desc.getClassName());
      // Before registering: a class without remote interfaces is refused here.
      ActivatableHandler.interfaces(implementation);
    } catch (ClassNotFoundException | MalformedURLException | IllegalArgumentException e) {
      throw new ActivationException(
          "The class " + desc.getClassName() + " cannot be registered as activatable", e);
    }
    ActivationID id = ActivationGroup.getSystem().registerObject(desc);
    return ActivatableHandler.proxy(id, implementation, null);
  }

  /**
   * Deactivates an object of this JVM's group: unexports it if it is idle, and notifies the daemon.
   *
   * @param id whose object
   * @return true if it is inactive now, false if it is busy
   * @throws UnknownObjectException if it is not active or not registered
   * @throws ActivationException if this JVM has no group
   * @throws RemoteException if the daemon cannot be notified
   */
  public static boolean inactive(ActivationID id)
      throws UnknownObjectException, ActivationException, RemoteException {
    return ActivationGroup.currentGroup().inactiveObject(id);
  }

  /**
   * Unregisters an object.
   *
   * @param id whose object
   * @throws UnknownObjectException if it is not registered
   * @throws ActivationException if there is no system, or it refuses
   * @throws RemoteException if the daemon cannot be reached
   */
  public static void unregister(ActivationID id)
      throws UnknownObjectException, ActivationException, RemoteException {
    ActivationGroup.getSystem().unregisterObject(id);
  }

  /**
   * Registers an object in this JVM's group, exports it and reports it active.
   *
   * @param obj the object
   * @param location the codebase of its class: URLs separated by spaces, or null
   * @param data the argument of its constructor when it is activated again, or null
   * @param restart true: activated when the daemon starts and after a crash; false: on demand only
   * @param port the TCP port, 0 for any
   * @return its identity from now on
   * @throws ActivationException if this JVM has no group, or the system refuses
   * @throws RemoteException if it cannot be exported, or the daemon cannot be reached
   */
  public static ActivationID exportObject(
      Remote obj, String location, MarshalledObject<?> data, boolean restart, int port)
      throws ActivationException, RemoteException {
    return exportObject(obj, location, data, restart, port, null, null);
  }

  /**
   * Registers an object in this JVM's group, exports it and reports it active. If that fails
   * half-way, it is neither registered nor exported.
   *
   * @param obj the object
   * @param location the codebase of its class: URLs separated by spaces, or null
   * @param data the argument of its constructor when it is activated again, or null
   * @param restart true: activated when the daemon starts and after a crash; false: on demand only
   * @param port the TCP port, 0 for any
   * @param csf makes the clients' sockets, or null for plain ones
   * @param ssf makes the server's sockets, or null for plain ones
   * @return its identity from now on
   * @throws ActivationException if this JVM has no group, or the system refuses
   * @throws RemoteException if it cannot be exported, or the daemon cannot be reached
   */
  public static ActivationID exportObject(
      Remote obj,
      String location,
      MarshalledObject<?> data,
      boolean restart,
      int port,
      RMIClientSocketFactory csf,
      RMIServerSocketFactory ssf)
      throws ActivationException, RemoteException {
    ActivationGroup group = ActivationGroup.currentGroup();
    ActivationSystem system = ActivationGroup.getSystem();
    ActivationID id =
        system.registerObject(
            new ActivationDesc(obj.getClass().getName(), location, data, restart));
    boolean done = false;
    try {
      exportObject(obj, id, port, csf, ssf);
      try {
        group.activeObject(id, obj);
        done = true;
      } finally {
        if (!done) {
          unexportObject(obj, true);
        }
      }
    } finally {
      if (!done) {
        system.unregisterObject(id);
      }
    }
    return id;
  }

  /**
   * Exports an object registered before.
   *
   * @param obj the object
   * @param id its identity
   * @param port the TCP port, 0 for any
   * @return a proxy with its remote interfaces, which activates it when it is not running
   * @throws RemoteException if it cannot be exported
   */
  public static Remote exportObject(Remote obj, ActivationID id, int port) throws RemoteException {
    return exportObject(obj, id, port, null, null);
  }

  /**
   * Exports an object registered before.
   *
   * @param obj the object
   * @param id its identity
   * @param port the TCP port, 0 for any
   * @param csf makes the clients' sockets, or null for plain ones
   * @param ssf makes the server's sockets, or null for plain ones
   * @return a proxy with its remote interfaces, which activates it when it is not running
   * @throws RemoteException if it cannot be exported
   */
  public static Remote exportObject(
      Remote obj, ActivationID id, int port, RMIClientSocketFactory csf, RMIServerSocketFactory ssf)
      throws RemoteException {
    Remote live = UnicastRemoteObject.exportObject(obj, port, csf, ssf);
    return ActivatableHandler.proxy(id, obj.getClass(), live);
  }

  /**
   * Unexports an object without notifying the daemon.
   *
   * @param obj the object
   * @param force true: even while calls are in progress
   * @return true if it is not exported any more, false if it is busy
   * @throws NoSuchObjectException if it was not exported
   */
  public static boolean unexportObject(Remote obj, boolean force) throws NoSuchObjectException {
    return UnicastRemoteObject.unexportObject(obj, force);
  }
}
