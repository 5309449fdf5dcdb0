package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
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
import org.dfra.core.directory.CachedModuleDirectory;
import org.dfra.directory.Locality;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.river.access.OwnAddresses;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.loading.BootClassPath;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.proxy.LocalModuleRegistry;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * The directory of the modules in all discoverable lookup services.
 *
 * <p>It answers from a cache. Events and periodic complete queries keep the cache up to date. If
 * lookup services become unreachable, their modules stay in the cache, marked stale. If a module's
 * lease expires at a reachable lookup service, the module is removed. A lookup service that returns
 * is found again within {@link DirectorySettings#locatorRetry}, or at its next announcement.
 *
 * <p>Threads: one for each locator and each lookup service, and {@code dfra-directory-watchdog},
 * which detects those that do not answer; {@link #close} stops them all.
 */
public final class JiniModuleDirectory extends CachedModuleDirectory {

  /** A numeric address, IPv4 or IPv6. */
  private static final Pattern ADDRESS =
      Pattern.compile("[0-9.]{7,15}|[0-9a-fA-F:.]*:[0-9a-fA-F:.]*");

  /** The limit of hosts in the cache of {@link #isHere}. */
  private static final int MOST_HOSTS = 1024;

  private final DirectorySettings settings;
  private final InstantSource clock;
  private final Discovery discovery;
  private final ServiceTable serviceTable;

  /** Guarded by itself. */
  private final Map<LocatedRegistrar, RegistrarMonitor> watches = new HashMap<>();

  /** Why lookup services and this program do not accept each other, by their names. */
  @GuardedBy("watches")
  private final Map<String, String> refusals = new TreeMap<>();

  private final Map<String, Boolean> hosts = new ConcurrentHashMap<>();
  private final ScheduledExecutorService watchdog;

  @GuardedBy("watches")
  private boolean closed;

  /**
   * Starts the discovery of lookup services, with robot timings.
   *
   * @param host address or name of this machine at which lookup services can call back
   * @param groups discovery groups, found by multicast; none if empty
   * @param locators {@code jini://host:port} each, found by unicast
   * @throws IOException if multicast cannot be used or a locator is malformed
   * @throws IllegalStateException if this virtual machine was started without the boot class path
   *     that proxies need; the message has the option that it needs
   */
  public JiniModuleDirectory(String host, List<String> groups, List<String> locators)
      throws IOException {
    this(DirectorySettings.of(host, groups, locators), InstantSource.system());
  }

  /**
   * Starts the discovery of lookup services.
   *
   * @param clock the time from which staleness is computed
   * @throws IOException if multicast cannot be used or a locator is malformed
   * @throws IllegalStateException if this virtual machine was started without the boot class path
   *     that proxies need; the message has the option that it needs
   */
  public JiniModuleDirectory(DirectorySettings settings, InstantSource clock) throws IOException {
    super(clock);
    BootClassPath.require();
    this.settings = settings;
    this.clock = clock;
    TrustedCode.installIfAbsent();
    this.serviceTable = new ServiceTable(table(), this::locality);
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
    // The last statements of a final class: all fields are set before another thread sees this.
    long period = Math.max(1, settings.registrarTimeout().toMillis() / 4);
    watchdog.scheduleWithFixedDelay(this::check, period, period, TimeUnit.MILLISECONDS);
    discovery.addDiscoveryListener(new RegistrarDiscoveryListener());
  }

  /**
   * The modules of reachable lookup services whose proxies cannot be read here. No query finds
   * them.
   */
  public List<UnreadableModule> unreadableModules() {
    return serviceTable.unreadable();
  }

  /**
   * The different services that reachable lookup services list under one service ID. A query finds
   * the one that was listed first.
   */
  public List<ModuleConflict> conflicts() {
    return serviceTable.conflicts();
  }

  /** How many lookup services are reachable now. */
  public int registrarCount() {
    synchronized (watches) {
      return watches.size();
    }
  }

  /**
   * Why this program finds nothing although lookup services were found: it and they do not accept
   * each other, for example since its certificate was revoked. Empty if one was read.
   */
  public List<String> refusals() {
    synchronized (watches) {
      return watches.values().stream().anyMatch(RegistrarMonitor::isRead)
          ? List.of()
          : List.copyOf(refusals.values());
    }
  }

  /** The lookup services that are reachable now. Several may claim one service ID. */
  public List<ServiceRegistrar> lookupServices() {
    synchronized (watches) {
      return watches.values().stream().<ServiceRegistrar>map(RegistrarMonitor::registrar).toList();
    }
  }

  /**
   * Waits until all reachable lookup services have been read once: a lookup service was found and
   * read at every locator. One that was found in time is read completely, unless it does not answer
   * for {@link DirectorySettings#registrarTimeout}. Multicast does not report when all have
   * answered, so with groups this always takes the whole timeout.
   *
   * @param timeout how long the discovery of lookup services may take
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

  @GuardedBy("watches")
  private boolean isAnyBeingRead() {
    return watches.values().stream().anyMatch(watch -> !watch.isRead());
  }

  /** The locators at which no lookup service was read. */
  @GuardedBy("watches")
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
      // Its monitor checks by itself whether it answers.
    }
  }

  private void watch(LocatedRegistrar registrar) {
    synchronized (watches) {
      if (!closed && !watches.containsKey(registrar)) {
        RegistrarMonitor watch =
            new RegistrarMonitor(
                registrar,
                serviceTable,
                settings,
                clock,
                JeriExporters.notKeepingAlive(
                    Endpoints.tcp(settings.callbackHost(), 0), new DeadlineILFactory()),
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
      watch.refusal().ifPresent(reason -> refusals.put(watch.registrar().toString(), reason));
      watches.notifyAll();
    }
    discovery.discard(watch.registrar()); // then search for it again
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
        if (hosts.size() > MOST_HOSTS) { // unknown clients may name any number
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
   * Whether the host in a module's entry is this computer. It does not resolve names: any client
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

  /**
   * Lookup services list different services under one service ID. One of them may come from an
   * unknown registrant. A module that was just restarted causes the same for a moment.
   *
   * @param path {@code robot/name} of the module, or the robot's name, in the listing that takes
   *     precedence
   * @param id the service ID
   * @param preferred the lookup service that takes precedence, as {@code address:port}
   * @param others the lookup services that list something else
   */
  public record ModuleConflict(String path, String id, String preferred, List<String> others) {

    public ModuleConflict {
      path = PrintableText.word(path);
      others = List.copyOf(others);
    }

    /** A sentence without a full stop: the conflict, its place, and the remedy. */
    public String describe() {
      return path
          + " is listed differently by the lookup services at "
          + preferred
          + ", which counts here, and "
          + String.join(", ", others)
          + "; if it was not restarted just now, find out whose those lookup services are";
    }
  }

  /**
   * A module whose proxy cannot be read here, most often because its classes are not trusted. The
   * other data come from its lookup service.
   *
   * @param robot name of its robot
   * @param name its name
   * @param host address of the computer it runs on
   * @param id its service ID
   * @param reason the reason and the remedy
   */
  public record UnreadableModule(String robot, String name, String host, String id, String reason) {

    public UnreadableModule {
      robot = PrintableText.word(robot);
      name = PrintableText.word(name);
    }

    /** {@code robot/name}. */
    public String path() {
      return robot + "/" + name;
    }
  }
}
