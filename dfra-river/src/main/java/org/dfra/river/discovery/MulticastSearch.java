package org.dfra.river.discovery;

import java.io.IOException;
import java.net.DatagramPacket;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.lookup.ServiceID;
import org.jspecify.annotations.Nullable;

/**
 * Finds the lookup services of some groups by multicast, until it is closed. It replaces River's
 * {@code LookupDiscovery} and reads the same configuration entries.
 *
 * <p>All searches of this virtual machine with equal settings share one {@link
 * SharedMulticastSearch}, which has the sockets and threads. So their number does not grow with the
 * number of modules. Each search has groups of its own, and reports each lookup service whether or
 * not another search has found it before.
 *
 * <p>A lookup service is identified by its proxy and not only by its service ID, which any host may
 * copy: all that claim one service ID are found, see {@link LocatedRegistrar}.
 */
public final class MulticastSearch implements AutoCloseable {

  /**
   * Receives the found and lost lookup services, one after the other, on the timer thread of the
   * search. It must not block.
   */
  public interface Listener {

    /** A lookup service was found. */
    void found(LocatedRegistrar registrar);

    /** A lookup service no longer answers, or left the groups. Not after a discard. */
    void lost(LocatedRegistrar registrar);
  }

  private final SharedMulticastSearch shared;
  private final SharedMulticastSearch.User user;

  private MulticastSearch(SharedMulticastSearch shared, SharedMulticastSearch.User user) {
    this.shared = shared;
    this.user = user;
  }

  /**
   * Starts the search.
   *
   * @param groups the groups; null for all
   * @param configuration entries of {@code net.jini.discovery.LookupDiscovery}
   * @throws IOException if multicast cannot be used
   * @throws ConfigurationException if an entry is invalid
   */
  public static MulticastSearch start(
      String @Nullable [] groups, Configuration configuration, Listener listener)
      throws IOException, ConfigurationException {
    MulticastSettings settings = MulticastSettings.of(configuration);
    SharedMulticastSearch.User user = new SharedMulticastSearch.User(groups, listener);
    return new MulticastSearch(SharedMulticastSearch.join(settings, user), user);
  }

  /** A search that shares nothing, with its own threads. For tests. */
  static MulticastSearch start(
      String @Nullable [] groups,
      MulticastSettings settings,
      Listener listener,
      DiscoveryThreads threads)
      throws IOException {
    SharedMulticastSearch own = new SharedMulticastSearch(settings, threads);
    SharedMulticastSearch.User user = new SharedMulticastSearch.User(groups, listener);
    own.add(user);
    return new MulticastSearch(own, user);
  }

  /** The groups, without duplicates; null for all. */
  public String @Nullable [] getGroups() {
    return shared.groups(user);
  }

  /**
   * Adds groups to the search.
   *
   * @throws UnsupportedOperationException if it searches for all
   * @throws IOException if multicast cannot be used
   */
  public void addGroups(String[] more) throws IOException {
    shared.addGroups(user, more);
  }

  /**
   * Replaces the groups of the search; lookup services that are in none of them are lost.
   *
   * @param wanted the groups; null for all
   * @throws IOException if multicast cannot be used
   */
  public void setGroups(String @Nullable [] wanted) throws IOException {
    shared.setGroups(user, wanted);
  }

  /**
   * Removes groups from the search; lookup services that are in no other group are lost.
   *
   * @throws UnsupportedOperationException if it searches for all
   */
  public void removeGroups(String[] unwanted) {
    shared.removeGroups(user, unwanted);
  }

  /** Handles a datagram. Also for tests. */
  void received(DatagramPacket packet) {
    shared.received(packet);
  }

  /** Whether a lookup service that claims this service ID is found now. */
  public boolean isDiscovered(ServiceID id) {
    return shared.known(user).stream().anyMatch(each -> each.getServiceID().equals(id));
  }

  /** Whether this lookup service is found now. */
  public boolean isDiscovered(LocatedRegistrar registrar) {
    return shared.known(user).contains(registrar);
  }

  /**
   * Forgets a lookup service that does not answer, and searches for it again. The other searches
   * keep it: it may answer their calls.
   */
  public void discard(LocatedRegistrar registrar) {
    shared.discard(user, registrar);
  }

  /** Ends the search. Running probes end by their deadlines. Idempotent. */
  @Override
  public void close() {
    shared.leave(user);
  }
}
