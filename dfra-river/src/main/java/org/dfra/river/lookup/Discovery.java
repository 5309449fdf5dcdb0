package org.dfra.river.lookup;

import java.io.IOException;
import java.net.MalformedURLException;
import java.util.List;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.discovery.LookupLocator;
import net.jini.discovery.ConstrainableLookupLocator;
import net.jini.discovery.DiscoveryManagement;
import net.jini.discovery.LookupDiscoveryManager;
import net.jini.discovery.LookupLocatorDiscovery;

/** How lookup services are found. */
final class Discovery {

  private Discovery() {}

  /**
   * Begins to look for lookup services, at the pace of {@link RobotPace}.
   *
   * @param groups discovery groups, found by multicast; where there are none, no multicast socket
   *     is opened
   * @param locators {@code jini://host:port} each, found by unicast
   * @throws IOException if multicast cannot be used or a locator is malformed
   */
  static DiscoveryManagement begin(
      List<String> groups, List<String> locators, Configuration configuration)
      throws IOException, ConfigurationException {
    Configuration paced = RobotPace.configuration(configuration);
    LookupLocator[] known = new LookupLocator[locators.size()];
    for (int i = 0; i < known.length; i++) {
      known[i] = locator(locators.get(i));
    }
    return groups.isEmpty()
        ? new LookupLocatorDiscovery(known, paced)
        : new LookupDiscoveryManager(groups.toArray(String[]::new), known, null, paced);
  }

  private static LookupLocator locator(String text) throws IOException {
    try {
      return new ConstrainableLookupLocator(text, RobotPace.ofLocators());
    } catch (MalformedURLException e) {
      throw new IOException(
          "the locator \"" + text + "\" is not of the form jini://host or jini://host:port", e);
    }
  }
}
