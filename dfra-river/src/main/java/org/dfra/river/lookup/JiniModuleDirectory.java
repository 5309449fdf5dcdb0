package org.dfra.river.lookup;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import net.jini.config.ConfigurationException;
import net.jini.config.EmptyConfiguration;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.discovery.DiscoveryEvent;
import net.jini.discovery.DiscoveryListener;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.core.directory.CachedModuleDirectory;
import org.dfra.directory.Locality;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.river.access.OwnAddresses;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.loading.BootClassPath;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.proxy.LocalModuleRegistry;
import org.jspecify.annotations.Nullable;

/**
 * The directory of what all lookup services hold that can be discovered.
 *
 * <p>It answers from a cache, which events and a periodic look at everything keep up to date. When
 * lookup services vanish it keeps what they held, marked stale; when a module's lease runs out at
 * one that is within reach, the module is gone. A lookup service that comes back is found again
 * within {@link DirectorySettings#locatorRetry}, or at its next announcement.
 *
 * <p>Threads: one for each locator and each lookup service, and {@code dfra-directory-watchdog},
 * which notices those that do not answer; {@link #close} ends them all.
 */
public final class JiniModuleDirectory extends CachedModuleDirectory {

  /** An address in figures, of either version. */
  private static final Pattern ADDRESS =
      Pattern.compile("[0-9.]{7,15}|[0-9a-fA-F:.]*:[0-9a-fA-F:.]*");

  /** For how many hosts it is kept whether they are this computer. */
  private static final int MOST_HOSTS = 1024;

  private final DirectorySettings settings;
  private final InstantSource clock;
  private final Discovery discovery;
  private final ServiceTable sightings;

  /** Guarded by itself. */
  private final Map<LocatedRegistrar, RegistrarMonitor> watches = new HashMap<>();

  private final Map<String, Boolean> hosts = new ConcurrentHashMap<>();
  private final ScheduledExecutorService watchdog;
  private boolean closed; // guarded by watches

  /**
   * Begins to discover lookup services, with robot timings.
   *
   * @param host address or name of this machine at which lookup services can call back
   * @param groups discovery groups, found by multicast; none if empty
   * @param locators {@code jini://host:port} each, found by unicast
   * @throws IOException if multicast cannot be used or a locator is malformed
   * @throws IllegalStateException if this virtual machine was started without the boot class path
   *     that proxies need; the message says with which option to start it
   */
  public JiniModuleDirectory(String host, List<String> groups, List<String> locators)
      throws IOException {
    this(DirectorySettings.of(host, groups, locators), InstantSource.system());
  }

  /**
   * Begins to discover lookup services.
   *
   * @param clock the time that staleness is reckoned by
   * @throws IOException if multicast cannot be used or a locator is malformed
   * @throws IllegalStateException if this virtual machine was started without the boot class path
   *     that proxies need; the message says with which option to start it
   */
  public JiniModuleDirectory(DirectorySettings settings, InstantSource clock) throws IOException {
    super(clock);
    BootClassPath.require();
    this.settings = settings;
    this.clock = clock;
    TrustedCode.installIfAbsent();
    this.sightings = new ServiceTable(table(), this::locality);
    try {
      this.discovery =
          Discovery.start(
              settings.groups(),
              settings.locators(),
              settings.locatorRetry(),
              LookupTimings.configuration(EmptyConfiguration.INSTANCE));
    } catch (ConfigurationException e) {
      throw new AssertionError("an empty configuration has no faults", e);
    }
    this.watchdog =
        Executors.newSingleThreadScheduledExecutor(
            task -> {
              Thread thread = new Thread(task, "dfra-directory-watchdog");
              thread.setDaemon(true);
              return thread;
            });
    long period = Math.max(1, settings.registrarTimeout().toMillis() / 4);
    watchdog.scheduleWithFixedDelay(this::check, period, period, TimeUnit.MILLISECONDS);
    discovery.addDiscoveryListener(new RegistrarDiscoveryListener());
  }

  /**
   * The modules that lookup services within reach hold, and whose proxies cannot be read here. No
   * query finds them.
   */
  public List<UnreadableModule> unreadableModules() {
    return sightings.unreadable();
  }

  /**
   * What lookup services within reach list differently under one service ID. A query finds the one
   * that was listed first.
   */
  public List<ModuleConflict> conflicts() {
    return sightings.conflicts();
  }

  /** How many lookup services are within reach now. */
  public int registrarCount() {
    synchronized (watches) {
      return watches.size();
    }
  }

  /** The lookup services that are within reach now. Several may claim one service ID. */
  public List<ServiceRegistrar> lookupServices() {
    synchronized (watches) {
      return watches.values().stream().<ServiceRegistrar>map(RegistrarMonitor::registrar).toList();
    }
  }

  /**
   * Waits until everything at hand has been looked at once: at every locator a lookup service was
   * found and what it holds was read. One that was found in time is read to the end, unless it
   * falls silent for {@link DirectorySettings#registrarTimeout}. Multicast never says that
   * everybody has answered, so with groups this always takes as long as it may.
   *
   * @param timeout how long lookup services may take to be found
   * @return the locators at which no lookup service was read meanwhile
   */
  public List<String> awaitFirstRead(Duration timeout) throws InterruptedException {
    long end = System.nanoTime() + timeout.toNanos();
    long readEnd = end + settings.registrarTimeout().toNanos();
    synchronized (watches) {
      while (true) {
        List<String> missing = unread();
        boolean isAllAsked = missing.isEmpty() && settings.groups().isEmpty();
        long left = (isAnyBeingRead() ? readEnd : end) - System.nanoTime();
        if (left <= 0 || closed || isAllAsked) {
          return missing;
        }
        TimeUnit.NANOSECONDS.timedWait(watches, left);
      }
    }
  }

  /** Holds the watches' lock. */
  private boolean isAnyBeingRead() {
    return watches.values().stream().anyMatch(watch -> !watch.isRead());
  }

  /** The locators at which no lookup service was read. Holds the watches' lock. */
  private List<String> unread() {
    List<String> missing = new ArrayList<>();
    discovery
        .registrarsByLocator()
        .forEach(
            (locator, found) -> {
              @Nullable RegistrarMonitor watch = found.map(watches::get).orElse(null);
              if (watch == null || !watch.isRead()) {
                missing.add(locator);
              }
            });
    return missing;
  }

  private void read() {
    synchronized (watches) {
      watches.notifyAll();
    }
  }

  private final class RegistrarDiscoveryListener implements DiscoveryListener {
    @Override
    public void discovered(DiscoveryEvent event) {
      for (ServiceRegistrar registrar : event.getRegistrars()) {
        watch((LocatedRegistrar) registrar); // discovery finds no others
      }
    }

    @Override
    public void discarded(DiscoveryEvent event) {
      // Its watch knows better whether it answers.
    }
  }

  private void watch(LocatedRegistrar registrar) {
    synchronized (watches) {
      if (!closed && !watches.containsKey(registrar)) {
        RegistrarMonitor watch =
            new RegistrarMonitor(
                registrar,
                sightings,
                settings,
                clock,
                new BasicJeriExporter(
                    Endpoints.tcp(settings.callbackHost(), 0),
                    new DeadlineILFactory(),
                    false,
                    false),
                this::read,
                this::lost);
        watches.put(registrar, watch);
        watch.start();
      }
    }
  }

  private void lost(RegistrarMonitor watch) {
    synchronized (watches) {
      watches.remove(watch.registrar(), watch);
      watches.notifyAll();
    }
    discovery.discard(watch.registrar()); // and look for it again
  }

  private void check() {
    List<RegistrarMonitor> all;
    synchronized (watches) {
      all = List.copyOf(watches.values());
    }
    long now = System.nanoTime();
    all.forEach(watch -> watch.check(now));
  }

  private Locality locality(UUID id, List<Attributes> attributes) {
    if (LocalModuleRegistry.contains(id)) {
      return Locality.SAME_VM;
    }
    for (Attributes each : attributes) {
      if (each instanceof ModuleAttributes module) {
        if (hosts.size() > MOST_HOSTS) { // strangers may name any number
          hosts.clear();
        }
        return hosts.computeIfAbsent(module.host(), this::isHere)
            ? Locality.SAME_HOST
            : Locality.REMOTE;
      }
    }
    return Locality.REMOTE;
  }

  /**
   * Whether a host that a module's entry names is this computer. Names are not looked up: anybody
   * may write them, and a look-up may take seconds.
   */
  private boolean isHere(String host) {
    if (host.equals(settings.callbackHost()) || host.equals("localhost")) {
      return true;
    }
    if (!ADDRESS.matcher(host).matches()) {
      return false;
    }
    try {
      return OwnAddresses.ofThisComputer().contains(InetAddress.getByName(host));
    } catch (UnknownHostException e) {
      return false;
    }
  }

  @Override
  public void close() {
    List<RegistrarMonitor> ending;
    synchronized (watches) {
      closed = true;
      ending = List.copyOf(watches.values());
      watches.clear();
      watches.notifyAll();
    }
    watchdog.shutdownNow();
    discovery.terminate();
    ending.forEach(RegistrarMonitor::close);
    super.close();
  }
}
