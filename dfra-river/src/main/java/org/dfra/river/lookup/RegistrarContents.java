package org.dfra.river.lookup;

import java.rmi.RemoteException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.loading.LoadingFaults;
import org.jspecify.annotations.Nullable;

/** Reads what a lookup service holds. */
final class RegistrarContents {

  /** A call of a lookup service. */
  interface RegistrarCall<T extends @Nullable Object, E extends Exception> {

    T ask() throws RemoteException, E;
  }

  /** Makes calls, and notes whether the lookup service answers. */
  interface Caller {

    <T extends @Nullable Object, E extends Exception> T call(RegistrarCall<T, E> asked)
        throws RemoteException, E;
  }

  private final ServiceRegistrar registrar;
  private final Caller caller;

  /**
   * @param caller makes each call
   */
  RegistrarContents(ServiceRegistrar registrar, Caller caller) {
    this.registrar = registrar;
    this.caller = caller;
  }

  /**
   * All modules and lookup services. Read robot by robot, so that no answer is too large for its
   * deadline.
   */
  Map<ServiceID, ServiceItem> items() throws RemoteException {
    Map<ServiceID, ServiceItem> items = new HashMap<>();
    ServiceTemplate modules = new ServiceTemplate(null, null, new Entry[] {new ModuleEntry()});
    @Nullable Object @Nullable [] robots =
        caller.call(
            () -> {
              try {
                return registrar.getFieldValues(modules, 0, "robot");
              } catch (NoSuchFieldException e) {
                throw new AssertionError(e);
              }
            });
    for (@Nullable Object robot : robots == null ? new Object[0] : robots) {
      ModuleEntry of = new ModuleEntry();
      of.robot = (String) robot;
      lookup(new ServiceTemplate(null, null, new Entry[] {of}), items);
    }
    lookup(new ServiceTemplate(null, new Class<?>[] {ServiceRegistrar.class}, null), items);
    return items;
  }

  private void lookup(ServiceTemplate template, Map<ServiceID, ServiceItem> items)
      throws RemoteException {
    ServiceMatches matches = caller.call(() -> registrar.lookup(template, Integer.MAX_VALUE));
    for (ServiceItem item : matches.items) {
      items.put(item.serviceID, item);
    }
  }

  /** How many services it holds. */
  int count() throws RemoteException {
    ServiceTemplate all = new ServiceTemplate(null, null, null);
    ServiceMatches none = caller.call(() -> registrar.lookup(all, 0));
    return none.totalMatches;
  }

  /** The host that it names as its own. */
  Optional<String> host() throws RemoteException {
    @Nullable LookupLocator locator = caller.call(() -> registrar.getLocator());
    return Optional.ofNullable(locator).map(LookupLocator::getHost);
  }

  /** Why a service's proxy cannot be read; this reads the service again, by itself. */
  Optional<String> fault(ServiceID service) throws RemoteException {
    ServiceTemplate one = new ServiceTemplate(service, null, null);
    return LoadingFaults.during(
        () -> {
          ServiceMatches unused = caller.call(() -> registrar.lookup(one, 1));
        });
  }
}
