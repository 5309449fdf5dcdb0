package org.dfra.river.registrar;

import com.sun.jini.thread.ReadersWriter;
import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import net.jini.core.lookup.ServiceID;
import net.jini.id.Uuid;
import org.jspecify.annotations.Nullable;

/**
 * Reggie's present contents, read under its own lock. Reggie itself determines whether a lease is
 * valid: a second record of renewals and expirations could differ from it.
 *
 * <p>Reggie 2.2.2 has no method for this, so its fields are used. Thread-safe.
 */
final class ReggieState implements RegistrationRules.LiveRegistrations {

  /**
   * A service that is registered with reggie.
   *
   * @param item reggie's form of a service item
   */
  record StoredService(ServiceID id, Object item) {}

  private final ReadersWriter lock;
  private final Map<?, ?> services; // by ServiceID
  private final Map<?, ?> listeners; // by Long
  private final Map<?, ?> attributes; // arrays of tables by descriptors of entry classes
  private final List<?> entryClasses; // descriptors
  private final Object reggie;
  private final Field objectType;
  private final Field ownId;
  private final Field maxServiceLease; // milliseconds
  private final Field maxListenerLease;
  private final Field serviceEnd; // milliseconds of the system clock
  private final Field listenerEnd;
  private final Field serviceLease; // its ID
  private final Field listenerLease;
  private final Field item; // of a registered service
  private final ReggieItems items;

  /**
   * @param reggie the lookup service
   * @param items the parts of its items
   * @throws ReflectiveOperationException if it is not reggie 2.2.2
   */
  ReggieState(Object reggie, ReggieItems items) throws ReflectiveOperationException {
    this.reggie = reggie;
    this.items = items;
    Class<?> type = ReggieFields.owner(reggie);
    ClassLoader loader = type.getClassLoader();
    Class<?> service = Class.forName(type.getName() + "$SvcReg", false, loader);
    Class<?> listener = Class.forName(type.getName() + "$EventReg", false, loader);
    lock = (ReadersWriter) ReggieFields.accessible(type, "concurrentObj").get(reggie);
    services = (Map<?, ?>) ReggieFields.accessible(type, "serviceByID").get(reggie);
    listeners = (Map<?, ?>) ReggieFields.accessible(type, "eventByID").get(reggie);
    attributes = (Map<?, ?>) ReggieFields.accessible(type, "serviceByAttr").get(reggie);
    entryClasses = (List<?>) ReggieFields.accessible(type, "entryClasses").get(reggie);
    ownId = ReggieFields.accessible(type, "myServiceID");
    objectType = ReggieFields.accessible(type, "objectServiceType");
    maxServiceLease = ReggieFields.accessible(type, "maxServiceLease");
    maxListenerLease = ReggieFields.accessible(type, "maxEventLease");
    serviceEnd = ReggieFields.accessible(service, "leaseExpiration");
    listenerEnd = ReggieFields.accessible(listener, "leaseExpiration");
    serviceLease = ReggieFields.accessible(service, "leaseID");
    listenerLease = ReggieFields.accessible(listener, "leaseID");
    item = ReggieFields.accessible(service, "item");
  }

  @Override
  public Set<ServiceID> liveServices(Set<ServiceID> among) {
    return live(services, serviceEnd, among);
  }

  @Override
  public Set<Long> liveListeners(Set<Long> among) {
    return live(listeners, listenerEnd, among);
  }

  private <K> Set<K> live(Map<?, ?> registrations, Field end, Set<K> among) {
    Set<K> live = new LinkedHashSet<>();
    lock.readLock();
    try {
      long now = System.currentTimeMillis();
      for (K each : among) {
        Object registration = registrations.get(each);
        if (registration != null && ReggieFields.number(end, registration) > now) {
          live.add(each);
        }
      }
    } finally {
      lock.readUnlock();
    }
    return live;
  }

  /**
   * The ID of the lease of a service or a listener.
   *
   * @param key a service ID, or the number of the listener's event
   * @return null if it is not registered
   */
  @Nullable Uuid lease(Object key) {
    boolean isService = key instanceof ServiceID;
    lock.readLock();
    try {
      @Nullable Object registration = (isService ? services : listeners).get(key);
      return registration == null
          ? null
          : (Uuid) ReggieFields.value(isService ? serviceLease : listenerLease, registration);
    } finally {
      lock.readUnlock();
    }
  }

  /** All its services except itself. */
  List<StoredService> services() {
    List<StoredService> all = new ArrayList<>();
    lock.readLock();
    try {
      for (Object each : services.values()) {
        Object held = ReggieFields.present(item, each);
        @Nullable ServiceID service = items.requestedId(held);
        if (ReggieFields.number(serviceEnd, each) != Long.MAX_VALUE && service != null) {
          all.add(new StoredService(service, held));
        }
      }
    } finally {
      lock.readUnlock();
    }
    return all;
  }

  /**
   * What a function makes of the items of all registered services, itself included, in reggie's
   * form.
   *
   * @param function called under reggie's lock; the item changes later. Null omits an item
   */
  List<Object> select(Function<Object, @Nullable Object> function) {
    List<Object> selected = new ArrayList<>();
    lock.readLock();
    try {
      long now = System.currentTimeMillis();
      for (Object each : services.values()) {
        @Nullable Object made =
            ReggieFields.number(serviceEnd, each) > now
                ? function.apply(ReggieFields.present(item, each))
                : null;
        if (made != null) {
          selected.add(made);
        }
      }
      return selected;
    } finally {
      lock.readUnlock();
    }
  }

  /** The same of one service; null if it is not registered. */
  @Nullable Object select(ServiceID service, Function<Object, @Nullable Object> function) {
    lock.readLock();
    try {
      @Nullable Object registration = services.get(service);
      return registration == null
              || ReggieFields.number(serviceEnd, registration) <= System.currentTimeMillis()
          ? null
          : function.apply(ReggieFields.present(item, registration));
    } finally {
      lock.readUnlock();
    }
  }

  /** Its own identifier. */
  ServiceID ownId() {
    return (ServiceID) ReggieFields.present(ownId, reggie);
  }

  /** The item of a service in reggie's form; null if it is not registered. */
  @Nullable Object item(ServiceID service) {
    lock.readLock();
    try {
      @Nullable Object registration = services.get(service);
      return registration == null ? null : ReggieFields.value(item, registration);
    } finally {
      lock.readUnlock();
    }
  }

  /**
   * The descriptor that reggie has for an entry class.
   *
   * @param descriptor a client's; reggie's has the same hash
   * @return null if no entry of the class is registered
   */
  @Nullable Object entryClass(Object descriptor) {
    lock.readLock();
    try {
      int at = entryClasses.indexOf(descriptor);
      return at < 0 ? null : entryClasses.get(at);
    } finally {
      lock.readUnlock();
    }
  }

  /**
   * The width of reggie's table for an entry class.
   *
   * @param descriptor a client's; reggie's has the same hash
   * @return -1 if there is no table
   */
  int entryFieldCount(Object descriptor) {
    lock.readLock();
    try {
      @Nullable Object tables = attributes.get(descriptor);
      return tables == null ? -1 : Array.getLength(tables);
    } finally {
      lock.readUnlock();
    }
  }

  /** Whether a descriptor of a type has the hash of {@link Object}. */
  boolean isObjectType(Object descriptor) {
    return descriptor.equals(ReggieFields.value(objectType, reggie));
  }

  /** The longest lease of a service that it grants now, in milliseconds. */
  long maxServiceLease() {
    return ReggieFields.number(maxServiceLease, reggie);
  }

  /** The longest lease of a listener that it grants now, in milliseconds. */
  long maxListenerLease() {
    return ReggieFields.number(maxListenerLease, reggie);
  }

  /** The identifiers of all its listeners. */
  List<Long> listeners() {
    List<Long> all = new ArrayList<>();
    lock.readLock();
    try {
      for (Object each : listeners.keySet()) {
        all.add((Long) each);
      }
    } finally {
      lock.readUnlock();
    }
    return all;
  }

  /**
   * The identifier under which reggie will register an item: its own, or that of the same proxy,
   * which it replaces.
   *
   * @param requested reggie's form of a service item
   * @return null if the identifier is free
   */
  @Nullable ServiceID effectiveId(Object requested) {
    @Nullable ServiceID own = items.requestedId(requested);
    @Nullable Object same = items.requestedService(requested);
    if (own != null || same == null) {
      return own;
    }
    lock.readLock();
    try {
      for (Object each : services.values()) {
        Object held = ReggieFields.present(item, each);
        if (same.equals(items.service(held))) {
          return items.serviceId(held);
        }
      }
      return null;
    } finally {
      lock.readUnlock();
    }
  }
}
