package org.dfra.river.lookup;

import java.io.IOException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.discovery.DiscoveryManagement;
import net.jini.jeri.BasicJeriExporter;
import net.jini.lease.LeaseRenewalManager;
import net.jini.lookup.ServiceDiscoveryManager;
import org.dfra.module.Module;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.jspecify.annotations.Nullable;

/**
 * Finds modules by the interface they implement, in the lookup services it discovers. A client
 * needs to know no more than that interface.
 */
public final class ModuleFinder implements AutoCloseable {

  private final DiscoveryManagement discovery;
  private final ServiceDiscoveryManager manager;

  /**
   * Begins to discover lookup services.
   *
   * @param host address or name of this machine at which lookup services can call back
   * @param groups discovery groups, found by multicast; none if empty
   * @param locators {@code jini://host:port} each, found by unicast
   * @throws IOException if multicast cannot be used or a locator is malformed
   */
  public ModuleFinder(String host, List<String> groups, List<String> locators) throws IOException {
    Configuration configuration =
        new SuppliedConfiguration(
            Map.of(
                "net.jini.lookup.ServiceDiscoveryManager.eventListenerExporter",
                () ->
                    new BasicJeriExporter(
                        Endpoints.tcp(host, 0), new DeadlineILFactory(), false, false)));
    try {
      discovery = Discovery.begin(groups, locators, configuration);
      manager =
          new ServiceDiscoveryManager(
              discovery, new LeaseRenewalManager(configuration), configuration);
    } catch (ConfigurationException e) {
      throw new AssertionError("the supplied entries have River's types", e);
    }
  }

  /**
   * Waits for a module that implements an interface.
   *
   * @param kind the interface
   * @param patience how long to wait for one
   * @return a proxy, or nothing where none was found in time
   */
  public <M extends Module> Optional<M> find(Class<M> kind, Duration patience)
      throws InterruptedException, RemoteException {
    @Nullable ServiceItem item =
        manager.lookup(
            new ServiceTemplate(null, new Class<?>[] {kind}, null),
            candidate -> kind.isInstance(candidate.service),
            patience.toMillis());
    return Optional.ofNullable(item).map(found -> kind.cast(found.service));
  }

  @Override
  public void close() {
    manager.terminate();
    discovery.terminate();
  }
}
