package org.dfra.river.lookup;

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
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.loading.BootClassPath;
import org.dfra.river.loading.TrustedCode;
import org.jspecify.annotations.Nullable;

/**
 * Looks once for the effectors that lookup services list, for an emergency: each is reported as
 * soon as it is read, whatever else is still to be read.
 *
 * <pre>
 *   discovery --&gt; RegistrarEffectorReader, one for each lookup service, in parallel
 *                   wanted and known robots first, then the other robots it lists
 * </pre>
 *
 * <p>A {@link JiniModuleDirectory} reads everything before it answers, so that thousands of modules
 * in one lookup service delay those of all robots. Nothing is followed here: what is registered
 * later is not found. Lookup services that claim one service ID are all read.
 */
public final class EffectorSearch implements AutoCloseable {

  /** What is reported, by any thread, also several times. Must not block. */
  public interface Listener {

    /**
     * A lookup service was found.
     *
     * @param registrar as in {@link ListedEffector#registrar}
     * @param host the computer where it says that it runs: a name or an address, not verified
     */
    void registrarFound(UUID registrar, String host);

    /** A lookup service lists an effector. */
    void found(ListedEffector effector);
  }

  /** How much longer than the patience lookup services that were found may take to be read. */
  private static final Duration READING = Duration.ofSeconds(3);

  private final List<String> groups;
  private final List<String> wanted;
  private final List<String> known;
  private final Listener listener;
  private final Discovery discovery;
  private final @Nullable ClassLoader loader = Thread.currentThread().getContextClassLoader();

  /** Guarded by itself. */
  private final Map<ServiceRegistrar, RegistrarEffectorReader> readings = new HashMap<>();

  private boolean closed; // guarded by readings

  /** Until then lookup services that do not answer are asked again, by {@link System#nanoTime}. */
  private volatile @Nullable Long findEnd; // once somebody waits

  /**
   * Begins to look.
   *
   * @param groups discovery groups, found by multicast; none if empty
   * @param locators {@code jini://host:port} each, found by unicast
   * @param wanted robots whose effectors are wanted, by name; all robots if empty
   * @param known robots that are read first where all are wanted
   * @throws IOException if multicast cannot be used or a locator is malformed
   * @throws IllegalStateException if this virtual machine was started without the boot class path
   *     that proxies need; the message says with which option to start it
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
            // What it listed is called all the same.
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
   * Waits until everything at hand was read: at every locator a lookup service was found, and each
   * that was found was read to its end. With groups this takes all the patience, since multicast
   * never says that everybody has answered; and 3 s longer where a lookup service is not read to
   * its end by then. What a lookup service does not answer in time it is asked again, twice in all
   * and while the patience lasts.
   *
   * @param timeout how long lookup services may take to be found
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

  /** Holds the readings' lock. */
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

  /** What was not read of lookup services that were found, and why; a sentence each. */
  public List<String> unread() {
    synchronized (readings) {
      return readings.values().stream().flatMap(each -> each.unread().stream()).toList();
    }
  }

  /** Ends it, without waiting for calls that are under way. */
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
}
