package java.rmi.activation;

import java.io.Closeable;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.net.InetAddress;
import java.net.MalformedURLException;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.MarshalledObject;
import java.rmi.NoSuchObjectException;
import java.rmi.NotBoundException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.ServerException;
import java.rmi.registry.LocateRegistry;
import java.rmi.server.RMIClassLoader;
import java.rmi.server.UnicastRemoteObject;
import org.dfra.activation.GroupPorts;

/**
 * Constructs activatable objects in its JVM and reports to the daemon which are active. There is
 * one group per JVM.
 *
 * <p>The daemon starts a JVM whose first act is {@link #createGroup}. A concrete subclass
 * constructs objects in {@link #newInstance}. This package has no such subclass, so a group
 * descriptor must name one. The constructor exports the group by JRMP; a subclass that wants
 * another protocol unexports itself first and has a {@code writeReplace} that returns its own
 * proxy, since the group passes itself to {@link ActivationSystem#activeGroup}.
 */
public abstract class ActivationGroup extends UnicastRemoteObject
    implements ActivationInstantiator {

  private static final long serialVersionUID = -7696947875314805420L;

  private static final String SYSTEM_NAME = "java.rmi.activation.ActivationSystem";
  private static final String NO_MONITOR =
      "The activation system returned no monitor for this group, so the group cannot report to it.";

  /** Attempts to report the group to a system that does not answer in time. */
  private static final int REPORTS = 3;

  private static final String PORT_PROPERTY = "java.rmi.activation.port";

  // All four are guarded by the class's lock.
  private static ActivationGroup currentGroup;
  private static ActivationGroupID currentID;
  private static ActivationSystem currentSystem;

  /** The group that {@link #createGroup} exported last, even if its constructor failed then. */
  private static ActivationGroup exported;

  /**
   * @serial the identity of this group
   */
  private final ActivationGroupID groupID;

  /**
   * @serial the monitor to which it reports its objects; null until the system knows the group, and
   *     if the system returned none
   */
  private ActivationMonitor monitor;

  /**
   * @serial the number given to this JVM when it was started
   */
  private long incarnation;

  /**
   * Exports the group by JRMP on an anonymous TCP port of the loopback interface: only the daemon
   * of the same host can reach it.
   *
   * @param groupID the identity of this group
   * @throws RemoteException if it cannot be exported
   */
  protected ActivationGroup(ActivationGroupID groupID) throws RemoteException {
    this(groupID, new LoopbackSocketFactory());
  }

  private ActivationGroup(ActivationGroupID groupID, LoopbackSocketFactory loopback)
      throws RemoteException {
    super(0, loopback, loopback);
    GroupPorts.opened(this, loopback::close);
    this.groupID = groupID;
    if (Thread.holdsLock(ActivationGroup.class)) {
      exported = this;
    }
  }

  /**
   * Deactivates an object. This implementation only notifies the daemon. A subclass unexports the
   * object first, and returns false without notifying the daemon if a call is in progress.
   *
   * @param id whose object
   * @return true if the object is inactive now, false if it is busy
   * @throws ActivationException if the group is not active
   * @throws UnknownObjectException if the object is not registered
   * @throws RemoteException if the daemon cannot be notified
   */
  public boolean inactiveObject(ActivationID id)
      throws ActivationException, UnknownObjectException, RemoteException {
    activeMonitor().inactiveObject(id);
    return true;
  }

  /**
   * Reports an object that became active other than through {@link #newInstance}.
   *
   * @param id whose object
   * @param obj the exported object
   * @throws ActivationException if the group is not active
   * @throws UnknownObjectException if the object is not registered
   * @throws RemoteException if the daemon cannot be notified
   */
  public abstract void activeObject(ActivationID id, Remote obj)
      throws ActivationException, UnknownObjectException, RemoteException;

  /**
   * Creates this JVM's group and reports it active.
   *
   * <p>The class named in the descriptor is loaded with {@link RMIClassLoader#loadClass(String,
   * String)}, must be a concrete subclass of this one, and have a public constructor {@code
   * (ActivationGroupID, MarshalledObject)}. The identity's system becomes this JVM's activation
   * system. If the system returns no monitor (null), the group is created but cannot report.
   *
   * @param id the identity under which the group was registered
   * @param desc the group's descriptor; it must name a class
   * @param incarnation the number given to this JVM when it was started
   * @return the group, an instance of the class named
   * @throws ActivationException if there is a group already, the identity names no system, the
   *     class does not fit, or the system refuses the group. A group that was already constructed
   *     is then unexported from JRMP, and closed if it is {@link Closeable}, so that it does not
   *     keep its JVM alive
   */
  public static synchronized ActivationGroup createGroup(
      ActivationGroupID id, ActivationGroupDesc desc, long incarnation) throws ActivationException {
    if (currentGroup != null) {
      throw new ActivationException(
          "This JVM already has an activation group, a "
              + currentGroup.getClass().getName()
              + ": start another JVM for another group.");
    }
    ActivationSystem system = id.getSystem();
    if (system == null) {
      throw new ActivationException(
          "The group's ID has no activation system: register the group with one first.");
    }
    ActivationGroup group = null;
    exported = null;
    try {
      group = construct(id, desc);
      group.incarnation = incarnation;
      group.monitor = report(system, id, group, incarnation);
    } catch (RemoteException e) {
      ActivationException refusal =
          new ActivationException(
              "The activation system cannot be notified that the group is active", e);
      withdraw(group, refusal);
      throw refusal;
    } catch (ActivationException | RuntimeException | Error e) {
      withdraw(group, e);
      throw e;
    }
    currentGroup = group;
    currentID = id;
    currentSystem = system;
    return group;
  }

  /**
   * Reports the group to the system. The report is repeated if the answer is late or lost. It is
   * not repeated if the connection is refused or the system refuses the group.
   */
  private static ActivationMonitor report(
      ActivationSystem system, ActivationGroupID id, ActivationGroup group, long incarnation)
      throws ActivationException, RemoteException {
    for (int attempt = 1; ; attempt++) {
      try {
        return system.activeGroup(id, group, incarnation);
      } catch (ConnectException | ConnectIOException | NoSuchObjectException | ServerException e) {
        throw e;
      } catch (RemoteException e) {
        if (attempt == REPORTS) {
          throw e;
        }
      }
    }
  }

  /**
   * Unexports a refused group, since an export keeps its JVM alive.
   *
   * @param group the group; null if its constructor failed
   * @param refusal receives failures that occur here as suppressed exceptions
   */
  private static void withdraw(ActivationGroup group, Throwable refusal) {
    if (exported != null) {
      unexport(exported);
      exported = null;
    }
    if (group instanceof Closeable closeable) {
      try {
        closeable.close();
      } catch (IOException | RuntimeException e) {
        refusal.addSuppressed(e);
      }
    }
  }

  private static ActivationGroup construct(ActivationGroupID id, ActivationGroupDesc desc)
      throws ActivationException {
    String name = desc.getClassName();
    if (name == null) {
      throw new ActivationException(
          "The group descriptor has no class name, and java.rmi.activation has no default group class:"
              + " give ActivationGroupDesc the name of a concrete subclass of ActivationGroup.");
    }
    try {
      return RMIClassLoader.loadClass(desc.getLocation(), name)
          .asSubclass(ActivationGroup.class)
          .getConstructor(ActivationGroupID.class, MarshalledObject.class)
          .newInstance(id, desc.getData());
    } catch (ClassNotFoundException | MalformedURLException e) {
      throw new ActivationException(
          "The group class " + name + " cannot be loaded from " + desc.getLocation(), e);
    } catch (ClassCastException e) {
      throw new ActivationException(
          "The group class " + name + " is not a subclass of " + ActivationGroup.class.getName(),
          e);
    } catch (NoSuchMethodException | IllegalAccessException e) {
      throw new ActivationException(
          "The group class "
              + name
              + " must be public and have a public constructor"
              + " (ActivationGroupID, MarshalledObject)",
          e);
    } catch (InstantiationException e) {
      throw new ActivationException("The group class " + name + " is abstract", e);
    } catch (InvocationTargetException e) {
      throw new ActivationException(
          "The constructor of the group class " + name + " failed", e.getCause());
    }
  }

  private static void unexport(ActivationGroup group) {
    try {
      unexportObject(group, true);
    } catch (NoSuchObjectException e) {
      // Its own class had unexported it, to export it by another protocol.
    }
  }

  /**
   * This JVM's group.
   *
   * @return its identity, or null if the JVM has no active group
   */
  public static synchronized ActivationGroupID currentGroupID() {
    return currentID;
  }

  /** This JVM's group; throws while there is none. */
  static synchronized ActivationGroup currentGroup() throws ActivationException {
    if (currentGroup == null) {
      throw new ActivationException(
          "This JVM has no active activation group: call ActivationGroup.createGroup first.");
    }
    return currentGroup;
  }

  /**
   * Sets this JVM's activation system, so that none is looked up.
   *
   * @param system the system
   * @throws ActivationException if a system is set already, by this method, by {@link #createGroup}
   *     or by a lookup
   */
  public static synchronized void setSystem(ActivationSystem system) throws ActivationException {
    if (currentSystem != null) {
      throw new ActivationException(
          "This JVM already has an activation system: set it before the first use of activation.");
    }
    currentSystem = system;
  }

  /**
   * This JVM's activation system: the one of its group, or the one that was set, or else the one
   * bound as {@code java.rmi.activation.ActivationSystem} in this host's RMI registry, at the TCP
   * port in the system property {@code java.rmi.activation.port}, by default {@link
   * ActivationSystem#SYSTEM_PORT}. The registry is queried at the loopback address.
   *
   * @return the system, never null
   * @throws ActivationException if none was set and none can be looked up
   */
  public static synchronized ActivationSystem getSystem() throws ActivationException {
    if (currentSystem == null) {
      currentSystem = lookUpSystem();
    }
    return currentSystem;
  }

  private static ActivationSystem lookUpSystem() throws ActivationException {
    int configured = Integer.getInteger(PORT_PROPERTY, ActivationSystem.SYSTEM_PORT);
    int port = configured > 0 ? configured : ActivationSystem.SYSTEM_PORT;
    try {
      String host = InetAddress.getLoopbackAddress().getHostAddress();
      return (ActivationSystem) LocateRegistry.getRegistry(host, port).lookup(SYSTEM_NAME);
    } catch (RemoteException | NotBoundException | ClassCastException e) {
      throw new ActivationException(
          "No activation system is bound as "
              + SYSTEM_NAME
              + " in the registry at port "
              + port
              + " of this host: start the activation daemon, or set the property "
              + PORT_PROPERTY,
          e);
    }
  }

  /**
   * Notifies the daemon that an object became active; for subclasses' {@link #activeObject(
   * ActivationID, Remote)}.
   *
   * @param id whose object
   * @param mobj its proxy, marshalled
   * @throws ActivationException if the group is not active
   * @throws UnknownObjectException if the object is not registered
   * @throws RemoteException if the daemon cannot be notified
   */
  protected void activeObject(ActivationID id, MarshalledObject<? extends Remote> mobj)
      throws ActivationException, UnknownObjectException, RemoteException {
    activeMonitor().activeObject(id, mobj);
  }

  /**
   * Notifies the daemon that the group has no active objects left. This JVM has no current group
   * afterwards, even if the notification fails.
   *
   * @throws UnknownGroupException if the group is not active, or the daemon does not know it
   * @throws RemoteException if the daemon cannot be notified
   */
  protected void inactiveGroup() throws UnknownGroupException, RemoteException {
    ActivationMonitor reported;
    boolean isCurrent;
    synchronized (ActivationGroup.class) {
      reported = monitor;
      monitor = null;
      isCurrent = currentGroup == this;
      if (isCurrent) {
        currentGroup = null;
        currentID = null;
      }
    }
    if (reported == null) {
      throw new UnknownGroupException(
          isCurrent ? NO_MONITOR : "This group is not active, so it cannot become inactive.");
    }
    reported.inactiveGroup(groupID, incarnation);
  }

  private ActivationMonitor activeMonitor() throws ActivationException {
    synchronized (ActivationGroup.class) {
      if (monitor == null) {
        throw new ActivationException(
            currentGroup == this
                ? NO_MONITOR
                : "This group is not active: it has no monitor before createGroup has returned,"
                    + " nor after inactiveGroup.");
      }
      return monitor;
    }
  }
}
