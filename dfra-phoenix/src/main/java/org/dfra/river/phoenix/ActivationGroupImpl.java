package org.dfra.river.phoenix;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.Closeable;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;
import java.rmi.server.RMIClassLoader;
import java.rmi.server.UnicastRemoteObject;
import java.time.Duration;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import net.jini.activation.ActivationGroup;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.config.ConfigurationProvider;
import net.jini.export.Exporter;
import net.jini.export.ProxyAccessor;
import org.dfra.activation.GroupPorts;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.phoenix.stop.GroupStopResult;
import org.dfra.river.phoenix.stop.StopTargetRegistry;
import org.dfra.river.phoenix.stop.StoppableGroup;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The group inside its virtual machine. It instantiates objects at the daemon's request, removes
 * them when they become inactive, and exits the machine when none is left.
 *
 * <p>Each object has its own lock. A slow constructor delays only the callers of that object.
 */
public final class ActivationGroupImpl extends ActivationGroup
    implements Closeable, StoppableGroup {

  private static final long serialVersionUID = 1L;

  private static final Logger LOG = LoggerFactory.getLogger(ActivationGroupImpl.class);

  private static final String COMPONENT = "org.dfra.river.phoenix.group";

  private static final String RIVERS_SERVICES = "com.sun.jini.";

  /** The daemon waits for an object's constructor, which may load classes and open ports. */
  private static final long INSTANTIATION_DEADLINE_MILLIS = 20_000;

  private final transient ActivationGroupID id;
  private final transient Exporter exporter;
  private final transient Remote proxy;
  private final transient Duration unexportTimeout;
  private final transient Duration unexportWait;
  private final transient Map<ActivationID, Slot> slots = new ConcurrentHashMap<>();
  private final transient ReadinessReporter readiness = new ReadinessReporter();
  private final transient StopTargetRegistry targets = new StopTargetRegistry();

  /** Held only briefly, never during an instantiation or a call to another object. */
  private final transient Object gate = new Object();

  // calls that may add an object
  @GuardedBy("gate")
  private transient int making;

  @GuardedBy("gate")
  private transient boolean left;

  /** Holds one object, instantiated once. The strong reference keeps JERI serving it. */
  private static final class Slot {
    volatile @Nullable Remote object; // written under this

    @GuardedBy("this")
    @Nullable MarshalledObject<? extends Remote> proxy;
  }

  /**
   * Called by {@code createGroup}.
   *
   * @param data arguments of the group's Jini configuration, or null for the defaults
   */
  public ActivationGroupImpl(ActivationGroupID id, @Nullable MarshalledObject<String[]> data)
      throws RemoteException, ActivationException {
    super(id);
    this.id = id;
    boolean unused = UnicastRemoteObject.unexportObject(this, true); // JERI exports this group
    GroupPorts.close(this);
    try {
      Configuration c =
          ConfigurationProvider.getInstance(data == null ? new String[0] : data.get());
      this.unexportTimeout =
          Duration.ofMillis((Long) c.getEntry(COMPONENT, "unexportTimeout", long.class, 5000L));
      this.unexportWait =
          Duration.ofMillis((Long) c.getEntry(COMPONENT, "unexportWait", long.class, 10L));
      this.exporter =
          JeriExporters.requireNoDistributedGc(
              Objects.requireNonNull(
                  (Exporter)
                      c.getEntry(
                          COMPONENT, "instantiatorExporter", Exporter.class, localExporter())),
              COMPONENT + ".instantiatorExporter");
      this.proxy = exporter.export(this);
    } catch (ConfigurationException
        | IllegalArgumentException
        | java.io.IOException
        | ClassNotFoundException e) {
      throw new ActivationException("the group's configuration cannot be used", e);
    }
  }

  private static Exporter localExporter() {
    return JeriExporters.keepingAlive(
        Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(INSTANTIATION_DEADLINE_MILLIS));
  }

  @Override
  public MarshalledObject<? extends Remote> newInstance(ActivationID object, ActivationDesc desc)
      throws ActivationException {
    if (!id.equals(desc.getGroupID())) {
      throw new ActivationException("the object's descriptor names another group");
    }
    enter();
    try {
      Slot slot = slots.computeIfAbsent(object, key -> new Slot());
      synchronized (slot) {
        if (slot.proxy == null) {
          long orders = targets.requestCount();
          Remote made = make(slot, object, desc);
          targets.made(object, made, orders); // before phoenix knows its proxy
          readiness.made(object, made);
        }
        return Objects.requireNonNull(slot.proxy);
      }
    } finally {
      leave();
    }
  }

  private void enter() throws InactiveGroupException {
    synchronized (gate) {
      if (left) {
        throw new InactiveGroupException("the group is ending and creates no more objects");
      }
      making++;
    }
  }

  private void leave() {
    synchronized (gate) {
      making--;
    }
  }

  @GuardedBy("slot")
  private static Remote make(Slot slot, ActivationID object, ActivationDesc desc)
      throws ActivationException {
    long began = System.nanoTime();
    Thread thread = Thread.currentThread();
    ClassLoader context = thread.getContextClassLoader();
    try {
      Class<?> type = RMIClassLoader.loadClass(desc.getLocation(), desc.getClassName(), context);
      thread.setContextClassLoader(type.getClassLoader());
      Constructor<?> constructor =
          type.getDeclaredConstructor(ActivationID.class, MarshalledObject.class);
      constructor.setAccessible(true);
      if (!(construct(constructor, object, desc) instanceof Remote made)) {
        throw new ActivationException(
            desc.getClassName() + " does not implement " + Remote.class.getName());
      }
      start(made, desc);
      slot.proxy = new MarshalledObject<>(proxyOf(made));
      slot.object = made;
      LOG.info("Made {} in {} ms.", made, TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - began));
      return made;
    } catch (InvocationTargetException e) {
      throw failure(desc, "its constructor failed", Objects.requireNonNull(e.getCause()));
    } catch (NoSuchMethodException e) {
      throw failure(desc, "it has no constructor (ActivationID, MarshalledObject)", e);
    } catch (ClassNotFoundException e) {
      throw failure(desc, "its class is not on the group's class path", e);
    } catch (ReflectiveOperationException | java.io.IOException | LinkageError e) {
      throw failure(desc, "it cannot be constructed", e);
    } finally {
      thread.setContextClassLoader(context);
    }
  }

  /** River's own services read their logs during construction, on the same thread. */
  private static Object construct(
      Constructor<?> constructor, ActivationID object, ActivationDesc desc)
      throws ReflectiveOperationException {
    return constructor.getDeclaringClass().getName().startsWith(RIVERS_SERVICES)
        ? SerialFilters.<Object, ReflectiveOperationException>readStored(
            () -> constructor.newInstance(object, desc.getData()))
        : constructor.newInstance(object, desc.getData());
  }

  private static void start(Remote made, ActivationDesc desc) throws ActivationException {
    if (!(made instanceof StartedObject object)) {
      return;
    }
    try {
      object.start();
    } catch (Exception | Error e) { // all that a constructor may throw is reported too
      throw failure(desc, "it did not start", e);
    }
  }

  private static Remote proxyOf(Remote made) throws ActivationException {
    if (!(made instanceof ProxyAccessor accessor)) {
      return made;
    }
    if (!(accessor.getProxy() instanceof Remote proxy)) {
      throw new ActivationException(made + " offers no remote proxy");
    }
    return proxy;
  }

  /**
   * The failure in a serializable form. A caller may lack the classes of the cause, so the
   * exception carries it as text; this group's log has it complete.
   */
  private static ActivationException failure(ActivationDesc desc, String what, Throwable cause) {
    LOG.error("{}: {}.", desc.getClassName(), what, cause);
    return new ActivationException(desc.getClassName() + ": " + what + ": " + cause);
  }

  /**
   * {@inheritDoc}
   *
   * <p>For objects exported by JRMP, which {@code java.rmi.activation} unexports.
   */
  @Override
  public boolean inactiveObject(ActivationID object) throws ActivationException, RemoteException {
    return deactivate(object, null);
  }

  @Override
  public boolean inactiveObject(ActivationID object, @Nullable Exporter itsExporter)
      throws ActivationException, RemoteException {
    return deactivate(object, Objects.requireNonNull(itsExporter, "exporter"));
  }

  private boolean deactivate(ActivationID object, @Nullable Exporter itsExporter)
      throws ActivationException, RemoteException {
    Slot slot = slots.get(object);
    if (slot == null) {
      throw new UnknownObjectException("object " + object + " is not active in this group");
    }
    @Nullable Exception failed = null;
    synchronized (slot) {
      @Nullable Remote active = slot.object;
      if (slots.get(object) != slot || active == null) {
        throw new UnknownObjectException("object " + object + " is not active in this group");
      }
      boolean unexported =
          itsExporter != null
              ? itsExporter.unexport(false)
              : UnicastRemoteObject.unexportObject(active, false);
      if (!unexported) {
        return false;
      }
      // Until the daemon knows, no call may instantiate the object again. So the lock is held.
      try {
        super.inactiveObject(object);
      } catch (UnknownObjectException e) {
        LOG.debug("Unregistered meanwhile, so nobody needs to know.", e);
      } catch (ActivationException | RemoteException e) {
        failed = e;
      }
      // Even if the daemon does not know: the object is unexported, so its proxy must not be
      // returned.
      slot.object = null;
      slot.proxy = null;
      readiness.inactive(object);
      targets.inactive(object);
    }
    leaveIfEmpty();
    if (failed instanceof RemoteException remote) {
      throw remote;
    } else if (failed instanceof ActivationException refused) {
      throw refused;
    }
    return true;
  }

  @Override
  public void activeObject(ActivationID object, Remote itself)
      throws ActivationException, RemoteException {
    MarshalledObject<? extends Remote> marshalled;
    try {
      marshalled = new MarshalledObject<>(proxyOf(itself));
    } catch (java.io.IOException e) {
      throw new ActivationException("the proxy of " + itself + " cannot be marshalled", e);
    }
    enter();
    try {
      Slot slot = slots.computeIfAbsent(object, key -> new Slot());
      synchronized (slot) {
        if (slot.object != null) {
          return; // known: a second activation is no error
        }
        slot.object = itself;
        slot.proxy = marshalled;
        targets.made(object, itself, targets.requestCount());
      }
    } finally {
      leave();
    }
    super.activeObject(object, marshalled);
  }

  /** {@inheritDoc} Takes no lock: instantiations and shutdowns of objects do not delay a stop. */
  @Override
  public GroupStopResult emergencyStop(String by) {
    return targets.emergencyStop(by);
  }

  /** The group stays active during an instantiation, whatever its result. */
  private void leaveIfEmpty() throws ActivationException, RemoteException {
    synchronized (gate) {
      if (left || making > 0) {
        return;
      }
      slots.values().removeIf(slot -> slot.object == null);
      if (!slots.isEmpty()) {
        return;
      }
      left = true;
    }
    try {
      inactiveGroup();
    } finally {
      // Even if the daemon received no report: this machine instantiates no more objects.
      new Thread(this::end, "group-end").start();
    }
  }

  /**
   * Unexports the group; the virtual machine continues to run. {@code createGroup} calls this if
   * the group is refused, so that its program can exit.
   */
  @Override
  public void close() {
    exporter.unexport(true);
  }

  /** Waits for running calls, then exits the virtual machine. */
  private void end() {
    long end = System.nanoTime() + unexportTimeout.toNanos();
    while (!exporter.unexport(false) && System.nanoTime() - end < 0) {
      LockSupport.parkNanos(this, unexportWait.toNanos());
    }
    exporter.unexport(true);
    LOG.info("Nothing is left to do in this group; its virtual machine ends.");
    Runtime.getRuntime().exit(0);
  }

  /** Returns the proxy that the daemon receives when this group reports to it. */
  private Object writeReplace() {
    return proxy;
  }

  private void readObject(java.io.ObjectInputStream in) throws java.io.InvalidObjectException {
    throw new java.io.InvalidObjectException("a group never leaves its virtual machine");
  }
}
