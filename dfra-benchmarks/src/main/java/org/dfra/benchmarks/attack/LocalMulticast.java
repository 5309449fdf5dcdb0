package org.dfra.benchmarks.attack;

import com.sun.jini.discovery.MulticastTimeToLive;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.util.List;
import java.util.Map;
import net.jini.config.ConfigurationException;
import net.jini.constraint.BasicMethodConstraints;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.MethodConstraints;
import net.jini.discovery.Constants;
import org.dfra.river.discovery.MulticastSearch;
import org.dfra.river.lookup.SuppliedConfiguration;

/** Discovery by multicast that does not leave this computer. */
public final class LocalMulticast {

  /** The constraints that keep the datagrams of a search or a lookup service on this computer. */
  public static final MethodConstraints CONSTRAINTS =
      new BasicMethodConstraints(new InvocationConstraints(new MulticastTimeToLive(0), null));

  /** The missing requirement if {@link #isPossible} returns false. */
  public static final String NEEDS = "a computer that receives its own multicast";

  private static final int PATIENCE_MILLIS = 2_000;

  private LocalMulticast() {}

  /** Whether this computer receives its own multicast; tries for at most two seconds. */
  public static boolean isPossible() {
    try (MulticastSocket receiver = new MulticastSocket();
        MulticastSocket sender = new MulticastSocket()) {
      InetAddress address = Constants.getRequestAddress();
      receiver.joinGroup(
          new InetSocketAddress(address, receiver.getLocalPort()), receiver.getNetworkInterface());
      receiver.setSoTimeout(PATIENCE_MILLIS);
      sender.setTimeToLive(0);
      sender.send(new DatagramPacket(new byte[1], 1, address, receiver.getLocalPort()));
      receiver.receive(new DatagramPacket(new byte[1], 1));
      return true;
    } catch (IOException e) { // no route, no interface, or no datagram arrived in time
      return false;
    }
  }

  /**
   * Discovers the lookup services of some groups, as a robot does that is not on the loopback.
   *
   * @param listener is notified of discovered services
   * @throws IOException if multicast cannot be used
   */
  public static MulticastSearch search(List<String> groups, MulticastSearch.Listener listener)
      throws IOException {
    try {
      return MulticastSearch.start(
          groups.toArray(String[]::new),
          new SuppliedConfiguration(
              Map.of("net.jini.discovery.LookupDiscovery.discoveryConstraints", () -> CONSTRAINTS)),
          listener);
    } catch (ConfigurationException e) {
      throw new IllegalStateException("the constraints of a local search are refused", e);
    }
  }
}
