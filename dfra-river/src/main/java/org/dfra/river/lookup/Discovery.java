package org.dfra.river.lookup;

import java.io.IOException;
import java.net.MalformedURLException;
import java.util.List;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.discovery.LookupLocator;
import net.jini.discovery.DiscoveryManagement;
import net.jini.discovery.LookupDiscoveryManager;
import net.jini.discovery.LookupLocatorDiscovery;

/** How lookup services are found. */
final class Discovery {

  private Discovery() {}

  /**
   * Begins to look for lookup services.
   *
   * @param groups discovery groups, found by multicast; where there are none, no multicast socket
   *     is opened
   * @param locators {@code jini://host:port} each, found by unicast
   * @throws IOException if multicast cannot be used or a locator is malformed
   */
  static DiscoveryManagement begin(
      List<String> groups, List<String> locators, Configuration configuration)
      throws IOException, ConfigurationException {
    LookupLocator[] known = new LookupLocator[locators.size()];
    for (int i = 0; i < known.length; i++) {
      known[i] = locator(locators.get(i));
    }
    return groups.isEmpty()
        ? new LookupLocatorDiscovery(known, configuration)
        : new LookupDiscoveryManager(groups.toArray(String[]::new), known, null, configuration);
  }

  private static LookupLocator locator(String text) throws IOException {
    try {
      return new LookupLocator(text);
    } catch (MalformedURLException e) {
      throw new IOException(
          "the locator \"" + text + "\" is not of the form jini://host or jini://host:port", e);
    }
  }
}
