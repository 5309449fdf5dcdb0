package org.dfra.attack.kit;

import java.io.Serializable;
import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.util.Arrays;
import java.util.Optional;
import net.jini.core.entry.Entry;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.lifecycle.Readiness;
import org.dfra.river.entry.ModuleEntry;
import org.jspecify.annotations.Nullable;

/** Registrations of things that are not what they claim to be. */
public final class Fakes {

  /** Milliseconds; the registrar grants what it grants at most. */
  public static final long LEASE_MILLIS = 60_000;

  private Fakes() {}

  /** What a module of a robot says of itself. */
  public static ModuleEntry module(String robot, String name) {
    ModuleEntry entry = new ModuleEntry();
    entry.robot = robot;
    entry.name = name;
    entry.driver = "org.example.Fake";
    entry.host = "10.0.0.66";
    entry.author = "";
    entry.version = "1";
    entry.state = Readiness.READY;
    entry.created = 0L;
    entry.clients = 0;
    return entry;
  }

  /**
   * Registers something.
   *
   * @param id the service ID; null for one of the registrar's choice
   * @param proxy anything serializable
   */
  public static ServiceRegistration register(
      ServiceRegistrar registrar, @Nullable ServiceID id, Object proxy, Entry... entries)
      throws RemoteException {
    return registrar.register(new ServiceItem(id, proxy, entries), LEASE_MILLIS);
  }

  /** What is registered under a service ID. */
  public static Optional<Object> proxy(ServiceRegistrar registrar, ServiceID id)
      throws RemoteException {
    return Optional.ofNullable(registrar.lookup(new ServiceTemplate(id, null, null)));
  }

  /** The service ID of the only service of a type. */
  public static ServiceID id(ServiceRegistrar registrar, Class<?> type) throws RemoteException {
    return Arrays.stream(
            registrar.lookup(new ServiceTemplate(null, new Class<?>[] {type}, null), 2).items)
        .map(item -> item.serviceID)
        .reduce(
            (one, other) -> {
              throw new IllegalStateException("two are of " + type + ": " + one + ", " + other);
            })
        .orElseThrow();
  }

  /** Registers a listener to a service that is not there. */
  public static long listen(ServiceRegistrar registrar) throws RemoteException {
    return registrar
        .notify(
            new ServiceTemplate(new ServiceID(4711, 4711), null, null),
            ServiceRegistrar.TRANSITION_NOMATCH_MATCH,
            deaf(),
            (MarshalledObject<?>) null,
            LEASE_MILLIS)
        .getID();
  }

  /** A listener that is copied, and to which nothing is to be reported. */
  public static RemoteEventListener deaf() {
    return new Deaf();
  }

  /** A listener that is copied, and does nothing. */
  private static final class Deaf implements RemoteEventListener, Serializable {

    private static final long serialVersionUID = 1L;

    @Override
    public void notify(RemoteEvent event) {
      throw new AssertionError("nothing is to be reported: " + event);
    }
  }
}
