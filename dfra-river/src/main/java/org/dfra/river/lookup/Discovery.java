package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.net.MalformedURLException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.discovery.DiscoveryEvent;
import net.jini.discovery.DiscoveryGroupManagement;
import net.jini.discovery.DiscoveryListener;
import net.jini.discovery.DiscoveryLocatorManagement;
import net.jini.discovery.DiscoveryManagement;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.discovery.MulticastSearch;
import org.jspecify.annotations.Nullable;

/**
 * Finds lookup services: by group over multicast, and at locators by unicast. One that is found
 * both ways counts once. Two that claim the same service ID count as two: each is a {@link
 * LocatedRegistrar}. Without groups, it opens no multicast socket.
 */
public final class Discovery
    implements DiscoveryManagement, DiscoveryGroupManagement, DiscoveryLocatorManagement {

  /** The delay before the next attempt at a locator that did not answer. */
  public static final Duration LOCATOR_RETRY = Duration.ofSeconds(1);

  private final Configuration configuration;
  private final Duration retry;
  private final List<DiscoveryListener> listeners = new CopyOnWriteArrayList<>();

  @GuardedBy("this")
  private final Set<LocatedRegistrar> found = new LinkedHashSet<>();

  @GuardedBy("this")
  private final List<LocatorSearch> searches = new ArrayList<>();

  @GuardedBy("this")
  private @Nullable MulticastSearch multicast;

  @GuardedBy("this")
  private boolean ended;

  private Discovery(Configuration configuration, Duration retry) {
    this.configuration = configuration;
    this.retry = retry;
  }

  /**
   * Starts the discovery of lookup services.
   *
   * @param groups discovery groups, found by multicast; none if empty
   * @param locators {@code jini://host:port} each, found by unicast
   * @param retry the delay before the next attempt at a locator that did not answer
   * @throws IOException if multicast cannot be used or a locator is malformed
   */
  static Discovery start(
      List<String> groups, List<String> locators, Duration retry, Configuration configuration)
      throws IOException, ConfigurationException {
    LookupLocator[] known = new LookupLocator[locators.size()];
    for (int i = 0; i < known.length; i++) {
      known[i] = locator(locators.get(i));
    }
    Discovery discovery = new Discovery(configuration, retry);
    if (!groups.isEmpty()) {
      discovery.multicast(groups.toArray(String[]::new));
    }
    discovery.addLocators(known);
    return discovery;
  }

  private static LookupLocator locator(String text) throws IOException {
    try {
      return new LookupLocator(text);
    } catch (MalformedURLException e) {
      throw new IOException(
          "the locator \"" + text + "\" is not of the form jini://host or jini://host:port", e);
    }
  }

  private synchronized void multicast(String @Nullable [] groups)
      throws IOException, ConfigurationException {
    multicast =
        MulticastSearch.start(
            groups,
            configuration,
            new MulticastSearch.Listener() {
              @Override
              public void found(LocatedRegistrar registrar) {
                add(registrar);
              }

              @Override
              public void lost(LocatedRegistrar registrar) {
                if (!isAtLocator(registrar)) {
                  remove(registrar);
                }
              }
            });
  }

  /** The lookup service found at each locator. */
  synchronized Map<String, Optional<LocatedRegistrar>> registrarsByLocator() {
    Map<String, Optional<LocatedRegistrar>> all = new LinkedHashMap<>();
    for (LocatorSearch search : searches) {
      all.put(search.locator().toString(), Optional.ofNullable(search.found()));
    }
    return all;
  }

  private synchronized boolean isAtLocator(LocatedRegistrar registrar) {
    return searches.stream().anyMatch(search -> registrar.equals(search.found()));
  }

  private void add(LocatedRegistrar registrar) {
    synchronized (this) {
      if (ended || !found.add(registrar)) {
        return;
      }
    }
    DiscoveryEvent event = new DiscoveryEvent(this, new ServiceRegistrar[] {registrar});
    listeners.forEach(listener -> listener.discovered(event));
  }

  private void remove(LocatedRegistrar registrar) {
    synchronized (this) {
      if (!found.remove(registrar)) {
        return;
      }
    }
    DiscoveryEvent event = new DiscoveryEvent(this, new ServiceRegistrar[] {registrar});
    listeners.forEach(listener -> listener.discarded(event));
  }

  @Override
  public void addDiscoveryListener(DiscoveryListener listener) {
    ServiceRegistrar[] known;
    synchronized (this) {
      listeners.add(listener);
      known = getRegistrars();
    }
    if (known.length > 0) {
      listener.discovered(new DiscoveryEvent(this, known));
    }
  }

  @Override
  public void removeDiscoveryListener(DiscoveryListener listener) {
    listeners.remove(listener);
  }

  @Override
  public synchronized ServiceRegistrar[] getRegistrars() {
    return found.toArray(ServiceRegistrar[]::new);
  }

  /**
   * {@inheritDoc} Then searches for it again.
   *
   * @param registrar one that was found here; others are ignored
   */
  @Override
  public void discard(ServiceRegistrar registrar) {
    if (registrar instanceof LocatedRegistrar located) {
      discard(located);
    }
  }

  private void discard(LocatedRegistrar registrar) {
    remove(registrar);
    @Nullable MulticastSearch groups;
    List<LocatorSearch> all;
    synchronized (this) {
      groups = multicast;
      all = List.copyOf(searches);
    }
    if (groups != null) {
      groups.discard(registrar);
    }
    all.forEach(search -> search.discard(registrar));
  }

  @Override
  public void terminate() {
    @Nullable MulticastSearch groups;
    List<LocatorSearch> all;
    synchronized (this) {
      ended = true;
      groups = multicast;
      all = List.copyOf(searches);
      searches.clear();
      listeners.clear();
    }
    if (groups != null) {
      groups.close();
    }
    all.forEach(LocatorSearch::close);
  }

  @Override
  @SuppressWarnings("NullAway") // null means all groups in Jini
  public synchronized String[] getGroups() {
    String @Nullable [] groups = multicast == null ? NO_GROUPS : multicast.getGroups();
    return groups != null && groups.length == 0 ? NO_GROUPS : groups;
  }

  @Override
  public synchronized void addGroups(String[] groups) throws IOException {
    if (multicast != null) {
      multicast.addGroups(groups);
    } else {
      setGroups(groups);
    }
  }

  @Override
  public synchronized void setGroups(String[] groups) throws IOException {
    if (multicast != null) {
      multicast.setGroups(groups);
    } else if (!ended && (groups == ALL_GROUPS || groups.length > 0)) {
      try {
        multicast(groups);
      } catch (ConfigurationException e) {
        throw new IOException("multicast discovery cannot be configured: " + e.getMessage(), e);
      }
    }
  }

  @Override
  public synchronized void removeGroups(String[] groups) {
    if (multicast != null) {
      multicast.removeGroups(groups);
    }
  }

  @Override
  public synchronized LookupLocator[] getLocators() {
    return searches.stream().map(LocatorSearch::locator).toArray(LookupLocator[]::new);
  }

  @Override
  public synchronized void addLocators(LookupLocator[] locators) {
    for (LookupLocator each : locators) {
      if (!ended && searches.stream().noneMatch(search -> search.locator().equals(each))) {
        searches.add(LocatorSearch.start(each, retry, this::add));
      }
    }
  }

  @Override
  public void setLocators(LookupLocator[] locators) {
    List<LookupLocator> wanted = Arrays.asList(locators);
    removeLocators(
        Arrays.stream(getLocators())
            .filter(each -> !wanted.contains(each))
            .toArray(LookupLocator[]::new));
    addLocators(locators);
  }

  @Override
  public void removeLocators(LookupLocator[] locators) {
    List<LookupLocator> unwanted = Arrays.asList(locators);
    List<LocatedRegistrar> lost = new ArrayList<>();
    synchronized (this) {
      List<LocatorSearch> ending =
          searches.stream().filter(search -> unwanted.contains(search.locator())).toList();
      searches.removeAll(ending);
      for (LocatorSearch search : ending) {
        search.close();
        @Nullable LocatedRegistrar registrar = search.found();
        if (registrar != null
            && found.contains(registrar)
            && !isAtLocator(registrar)
            && (multicast == null || !multicast.isDiscovered(registrar))) {
          lost.add(registrar);
        }
      }
    }
    lost.forEach(this::remove);
  }
}
