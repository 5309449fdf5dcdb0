package org.dfra.river.discovery;

import com.sun.jini.discovery.DiscoveryConstraints;
import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.config.NoSuchEntryException;
import net.jini.constraint.BasicMethodConstraints;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.MethodConstraints;
import net.jini.security.BasicProxyPreparer;
import net.jini.security.ProxyPreparer;
import org.jspecify.annotations.Nullable;

/**
 * The settings of multicast discovery: the entries of {@value #COMPONENT} in a Jini configuration,
 * which is the name of River's class for it.
 *
 * @param interfaces the interfaces for sending and receiving; the system chooses for a null element
 * @param isListed whether the interfaces were configured: then the failure of one is reported
 * @param host address for responses; only version 2 sends it
 * @param version of the requests, 1 or 2; announcements of both are decoded
 * @param packetBytes maximum size of a datagram, in bytes
 * @param timeToLive maximum number of routers that a request may pass
 * @param requests number of requests when a search starts
 * @param requestInterval time between two of these
 * @param finalRequestInterval how long the search waits for responses to the last one
 * @param requestDelay maximum random delay of the first request
 * @param announcementInterval expected interval of announcements
 * @param interfaceRetry interval of retries of an interface that failed
 * @param preparer prepares the proxies that are found
 */
record MulticastSettings(
    List<@Nullable NetworkInterface> interfaces,
    boolean isListed,
    String host,
    int version,
    int packetBytes,
    int timeToLive,
    int requests,
    Duration requestInterval,
    Duration finalRequestInterval,
    Duration requestDelay,
    Duration announcementInterval,
    Duration interfaceRetry,
    ProxyPreparer preparer) {

  static final String COMPONENT = "net.jini.discovery.LookupDiscovery";

  private static final int PACKET_BYTES = 512;
  private static final int TIME_TO_LIVE = 15;

  /**
   * Reads a configuration.
   *
   * @throws ConfigurationException if an entry is invalid, or names constraints that plain
   *     discovery cannot satisfy
   * @throws IOException if this computer's interfaces cannot be listed
   */
  @SuppressWarnings("NullAway") // getEntry takes a null default
  static MulticastSettings of(Configuration configuration)
      throws ConfigurationException, IOException {
    ProxyPreparer preparer =
        entry(
            configuration,
            "registrarPreparer",
            ProxyPreparer.class,
            ProxyPreparer.class,
            new BasicProxyPreparer());
    MethodConstraints constraints =
        (MethodConstraints)
            configuration.getEntry(
                COMPONENT, "discoveryConstraints", MethodConstraints.class, null);
    if (constraints == null) {
      constraints = new BasicMethodConstraints(InvocationConstraints.EMPTY);
    }
    DiscoveryConstraints request = constraints(constraints, "multicastRequest");
    DiscoveryConstraints announcement = constraints(constraints, "multicastAnnouncement");
    constraints(constraints, "unicastDiscovery").checkProtocolVersion(1);
    int requests = entry(configuration, "multicastRequestMax", int.class, Integer.class, 7);
    Duration interval = millis(configuration, "multicastRequestInterval", 5_000);
    Duration last = millis(configuration, "finalMulticastRequestInterval", 120_000);
    Duration delay = millis(configuration, "initialMulticastRequestDelayRange", 0);
    Duration announcements = millis(configuration, "multicastAnnouncementInterval", 120_000);
    int retry =
        entry(configuration, "multicastInterfaceRetryInterval", int.class, Integer.class, 300_000);
    int version = request.chooseProtocolVersion();
    @Nullable NetworkInterface @Nullable [] listed = null;
    boolean isListed = true;
    try {
      listed =
          (NetworkInterface[])
              configuration.getEntry(COMPONENT, "multicastInterfaces", NetworkInterface[].class);
      if (listed == null) {
        listed = new NetworkInterface[] {null};
      }
    } catch (NoSuchEntryException e) {
      isListed = false;
      listed = NetworkInterface.networkInterfaces().toArray(NetworkInterface[]::new);
    }
    return new MulticastSettings(
        Arrays.asList(listed),
        isListed,
        host(configuration, version, Arrays.asList(listed)),
        version,
        Math.max(
            request.getMulticastMaxPacketSize(PACKET_BYTES),
            announcement.getMulticastMaxPacketSize(PACKET_BYTES)),
        request.getMulticastTimeToLive(TIME_TO_LIVE),
        requests,
        interval,
        last,
        delay,
        announcements,
        Duration.ofMillis(retry),
        preparer);
  }

  private static DiscoveryConstraints constraints(MethodConstraints of, String method)
      throws ConfigurationException, IOException {
    try {
      DiscoveryConstraints constraints =
          DiscoveryConstraints.process(
              of.getConstraints(DiscoveryConstraints.class.getMethod(method)));
      if (!constraints.getUnfulfilledConstraints().requirements().isEmpty()) {
        throw new ConfigurationException(
            COMPONENT
                + ".discoveryConstraints requires "
                + constraints.getUnfulfilledConstraints()
                + ", which plain discovery cannot fulfil; leave them out");
      }
      return constraints;
    } catch (NoSuchMethodException e) {
      throw new AssertionError("River's own", e);
    }
  }

  private static String host(
      Configuration configuration, int version, List<@Nullable NetworkInterface> interfaces)
      throws ConfigurationException, IOException {
    try {
      return (String) configuration.getEntry(COMPONENT, "multicastRequestHost", String.class);
    } catch (NoSuchEntryException e) {
      return version == 1
          ? InetAddress.getLoopbackAddress().getHostAddress() // not sent
          : address(interfaces);
    }
  }

  /**
   * An IPv4 address of the interfaces, if possible one that other hosts can reach. No name service
   * is used: it may take long to answer, or return another address.
   */
  private static String address(List<@Nullable NetworkInterface> interfaces) throws IOException {
    List<NetworkInterface> sending = new ArrayList<>();
    for (@Nullable NetworkInterface each : interfaces) {
      if (each == null) { // the system chooses the interface
        for (NetworkInterface one : NetworkInterface.networkInterfaces().toList()) {
          if (one.isUp() && !one.isVirtual() && !one.isPointToPoint()) {
            sending.add(one);
          }
        }
      } else {
        sending.add(each);
      }
    }
    return sending.stream()
        .flatMap(NetworkInterface::inetAddresses)
        .filter(Inet4Address.class::isInstance)
        .min(
            Comparator.comparing(InetAddress::isLoopbackAddress)
                .thenComparing(InetAddress::isLinkLocalAddress))
        .orElseGet(InetAddress::getLoopbackAddress)
        .getHostAddress();
  }

  private static Duration millis(Configuration configuration, String name, long otherwise)
      throws ConfigurationException {
    long millis = entry(configuration, name, long.class, Long.class, otherwise);
    if (millis < 0) {
      throw new ConfigurationException(
          COMPONENT + "." + name + " = " + millis + " ms is less than 0; give 0 or more");
    }
    return Duration.ofMillis(millis);
  }

  private static <T> T entry(
      Configuration configuration, String name, Class<?> type, Class<T> boxed, T otherwise)
      throws ConfigurationException {
    Object value = configuration.getEntry(COMPONENT, name, type, otherwise);
    if (value == null) {
      throw new ConfigurationException(COMPONENT + "." + name + " is null; name a value");
    }
    return boxed.cast(value);
  }
}
