package org.dfra.river.discovery;

import com.sun.jini.discovery.MulticastAnnouncement;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.NetworkInterface;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import net.jini.config.ConfigurationException;
import net.jini.core.lookup.ServiceID;
import org.dfra.river.lookup.SuppliedConfiguration;

/**
 * A search of all groups that a test gives datagrams to. It has the threads of a robot's search,
 * except those that read sockets: it sends and receives no datagram.
 */
public final class DatagramSearch implements AutoCloseable {

  private final Set<String> hosts;
  private final MulticastSearch search;
  private int withheld;

  /**
   * Begins to search.
   *
   * @param hosts the addresses that it may connect to. A datagram that announces a lookup service
   *     at another one is decoded and then dropped: a test connects to no other computer
   */
  public DatagramSearch(Set<String> hosts) throws IOException, ConfigurationException {
    this.hosts = Set.copyOf(hosts);
    NetworkInterface[] none = {};
    this.search =
        MulticastSearch.start(
            null,
            new SuppliedConfiguration(
                Map.of(MulticastSettings.COMPONENT + ".multicastInterfaces", () -> none)),
            new MulticastSearch.Listener() {
              @Override
              public void found(LocatedRegistrar registrar) {
                // isDiscovered reports it
              }

              @Override
              public void lost(LocatedRegistrar registrar) {
                // isDiscovered reports it
              }
            });
  }

  /** Does what the search does when a datagram arrives. For one thread. */
  public void receive(DatagramPacket packet) {
    Optional<MulticastAnnouncement> announcement = DiscoveryPackets.decodeAnnouncement(packet);
    if (announcement.isPresent() && !hosts.contains(announcement.get().getHost())) {
      withheld++;
    } else {
      search.received(packet);
    }
  }

  /** How many datagrams were dropped because they name another host. */
  public int withheld() {
    return withheld;
  }

  /** Whether a lookup service with this service ID is found now. */
  public boolean isDiscovered(ServiceID id) {
    return search.isDiscovered(id);
  }

  @Override
  public void close() {
    search.close();
  }
}
