package org.dfra.river.lookup;

import java.time.Duration;
import java.util.List;

/**
 * How a directory uses lookup services.
 *
 * @param callbackHost address or name of this machine at which lookup services can call back
 * @param groups discovery groups, found by multicast; none if empty
 * @param locators lookup services found by unicast, {@code jini://host:port} each
 * @param locatorRetry the delay before the next attempt at a locator that did not answer
 * @param heartbeatInterval interval of the heartbeats to each lookup service; each costs one call
 * @param registrarTimeout how long a lookup service may take to answer before its registrations are
 *     stale
 * @param reconcileInterval interval of comparisons of the number of services, in case an event was
 *     lost; each costs one call
 * @param eventLease lease on the events; after it a lookup service removes a dead client
 */
public record DirectorySettings(
    String callbackHost,
    List<String> groups,
    List<String> locators,
    Duration locatorRetry,
    Duration heartbeatInterval,
    Duration registrarTimeout,
    Duration reconcileInterval,
    Duration eventLease) {

  public DirectorySettings {
    groups = List.copyOf(groups);
    locators = List.copyOf(locators);
    if (eventLease.compareTo(heartbeatInterval.multipliedBy(2)) < 0) {
      throw new IllegalArgumentException(
          "eventLease "
              + eventLease.toMillis()
              + " ms < 2 × heartbeat "
              + heartbeatInterval.toMillis()
              + " ms; beat faster or ask for a longer lease");
    }
  }

  /** Robot timings: heartbeats of 1 s, a timeout of 3 s, a comparison every 30 s. */
  public static DirectorySettings of(String host, List<String> groups, List<String> locators) {
    return new DirectorySettings(
        host,
        groups,
        locators,
        Discovery.LOCATOR_RETRY,
        Duration.ofSeconds(1),
        Duration.ofSeconds(3),
        Duration.ofSeconds(30),
        Duration.ofSeconds(10));
  }
}
