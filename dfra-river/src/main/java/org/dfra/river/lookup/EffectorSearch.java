package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import net.jini.config.ConfigurationException;
import net.jini.config.EmptyConfiguration;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.discovery.DiscoveryEvent;
import net.jini.discovery.DiscoveryListener;
import org.dfra.flow.effector.Effector;
import org.dfra.persona.Attributes;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.loading.BootClassPath;
import org.dfra.river.loading.TrustedCode;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * Searches once for the effectors that lookup services list, for an emergency. It reports each
 * effector as soon as it is read, without waiting for the others.
 *
 * <pre>
 *   discovery --&gt; RegistrarEffectorReader, one for each lookup service, in parallel
 *                   wanted and known robots first, then the other robots it lists
 * </pre>
 *
 * <p>A {@link JiniModuleDirectory} reads everything before it answers, so thousands of modules in
 * one lookup service would delay those of all robots. This search receives no events: it does not
 * find later registrations. It reads all lookup services, even if several claim one service ID.
 */
public final class EffectorSearch implements AutoCloseable {

  /** Receives the results, on any thread, possibly several times. Must not block. */
  public interface Listener {

    /**
     * A lookup service was found.
     *
     * @param registrar as in {@link ListedEffector#registrar}
     * @param host the computer that it claims to run on: a name or an address, not verified
     */
    void registrarFound(UUID registrar, String host);

    /** A lookup service lists an effector. */
    void found(ListedEffector effector);
  }

  /** How much longer than the timeout the reading of found lookup services may take. */
  private static final Duration READING = Duration.ofSeconds(3);

  private final List<String> groups;
  private final List<String> wanted;
  private final List<String> known;
  private final Listener listener;
  private final Discovery discovery;
  private final @Nullable ClassLoader loader = Thread.currentThread().getContextClassLoader();

  /** Guarded by itself. */
  private final Map<ServiceRegistrar, RegistrarEffectorReader> readings = new HashMap<>();

  @GuardedBy("readings")
  private boolean closed;

  /** Until then, unanswered queries are repeated; {@link System#nanoTime}. */
  private volatile @Nullable Long findEnd; // set by awaitRead

  /**
   * Starts the search.
   *
   * @param groups discovery groups, found by multicast; none if empty
   * @param locators {@code jini://host:port} each, found by unicast
   * @param wanted robots whose effectors are wanted, by name; all robots if empty
   * @param known robots that are read first if all are wanted
   * @throws IOException if multicast cannot be used or a locator is malformed
   * @throws IllegalStateException if this virtual machine was started without the boot class path
   *     that proxies need; the message has the option that it needs
   */
  public EffectorSearch(
      List<String> groups,
      List<String> locators,
      List<String> wanted,
      List<String> known,
      Listener listener)
      throws IOException {
    BootClassPath.require();
    TrustedCode.installIfAbsent();
    this.groups = List.copyOf(groups);
    this.wanted = List.copyOf(wanted);
    this.known = List.copyOf(known);
    this.listener = listener;
    try {
      this.discovery =
          Discovery.start(
              groups,
              locators,
              Discovery.LOCATOR_RETRY,
              LookupTimings.configuration(EmptyConfiguration.INSTANCE));
    } catch (ConfigurationException e) {
      throw new AssertionError("an empty configuration has no faults", e);
    }
    discovery.addDiscoveryListener(
        new DiscoveryListener() {
          @Override
          public void discovered(DiscoveryEvent event) {
            for (ServiceRegistrar registrar : event.getRegistrars()) {
              read(registrar);
            }
          }

          @Override
          public void discarded(DiscoveryEvent event) {
            // The effectors that it listed are still valid.
          }
        });
  }

  private void read(ServiceRegistrar registrar) {
    synchronized (readings) {
      if (!closed && !readings.containsKey(registrar)) {
        RegistrarEffectorReader reading =
            new RegistrarEffectorReader(
                registrar, wanted, known, listener, loader, this::changed, this::isTimeLeft);
        readings.put(registrar, reading);
        reading.start();
      }
    }
  }

  private boolean isTimeLeft() {
    @Nullable Long end = findEnd;
    return end != null && end - System.nanoTime() > 0;
  }

  private void changed() {
    synchronized (readings) {
      readings.notifyAll();
    }
  }

  /**
   * Waits until all reachable lookup services are read: a lookup service was found at every
   * locator, and each found one was read completely. With groups this always takes the whole
   * timeout, since multicast does not report when all have answered. It takes 3 s longer if a
   * lookup service is not read completely by then. An unanswered query is sent at least twice, and
   * again until the timeout.
   *
   * @param timeout how long the discovery of lookup services may take
   * @return the locators at which no lookup service was found
   */
  public List<String> awaitRead(Duration timeout) throws InterruptedException {
    long end = System.nanoTime() + timeout.toNanos();
    long readEnd = end + READING.toNanos();
    findEnd = end;
    synchronized (readings) {
      while (true) {
        List<String> missing = missing();
        boolean isReading = readings.values().stream().anyMatch(each -> !each.isOver());
        boolean isAllFound = missing.isEmpty() && groups.isEmpty();
        long left = (isReading ? readEnd : end) - System.nanoTime();
        if (left <= 0 || closed || (isAllFound && !isReading)) {
          return missing;
        }
        TimeUnit.NANOSECONDS.timedWait(readings, left);
      }
    }
  }

  @GuardedBy("readings")
  private List<String> missing() {
    List<String> missing = new ArrayList<>();
    discovery
        .registrarsByLocator()
        .forEach(
            (locator, found) -> {
              Optional<LocatedRegistrar> there = found.filter(readings::containsKey);
              if (there.isEmpty()) {
                missing.add(locator);
              }
            });
    return missing;
  }

  /** What was not read from found lookup services, and why; a sentence each. */
  public List<String> unread() {
    synchronized (readings) {
      return readings.values().stream().flatMap(each -> each.unread().stream()).toList();
    }
  }

  /** Closes the search without waiting for running calls. */
  @Override
  public void close() {
    List<RegistrarEffectorReader> ending;
    synchronized (readings) {
      closed = true;
      ending = List.copyOf(readings.values());
      readings.notifyAll();
    }
    discovery.terminate();
    ending.forEach(RegistrarEffectorReader::close);
  }

  /**
   * An effector in a lookup service. All of it is unverified data of the registrant.
   *
   * @param id its service ID
   * @param registrar which lookup service lists it: a key of this search, since the service ID that
   *     a lookup service claims may be a copy
   * @param robot name of its robot, as a printable word
   * @param name its name on its robot, as a printable word
   * @param effector its proxy; null if it cannot be read here
   * @param attributes its attributes
   */
  public record ListedEffector(
      UUID id,
      UUID registrar,
      String robot,
      String name,
      @Nullable Effector<?> effector,
      List<Attributes> attributes) {

    public ListedEffector {
      robot = PrintableText.word(robot);
      name = PrintableText.word(name);
      attributes = List.copyOf(attributes);
    }

    /** {@code robot/name}. */
    public String path() {
      return robot + "/" + name;
    }
  }
}
