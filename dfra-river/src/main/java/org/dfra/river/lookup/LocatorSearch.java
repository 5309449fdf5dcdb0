package org.dfra.river.lookup;

import java.time.Duration;
import java.util.function.Consumer;
import net.jini.core.discovery.LookupLocator;
import org.dfra.river.discovery.LocatedRegistrar;
import org.jspecify.annotations.Nullable;

/**
 * Searches for the lookup service at one locator, at a fixed rate, until it is found, and again
 * when it is discarded. River's own search increases its delay after each failure, up to minutes.
 *
 * <p>All searches of this virtual machine at one locator share a {@link SharedLocatorSearch}.
 */
final class LocatorSearch implements AutoCloseable {

  private final LookupLocator locator;
  private final SharedLocatorSearch shared;
  private final SharedLocatorSearch.User user;

  private LocatorSearch(
      LookupLocator locator, SharedLocatorSearch shared, SharedLocatorSearch.User user) {
    this.locator = locator;
    this.shared = shared;
    this.user = user;
  }

  /**
   * Starts the search.
   *
   * @param retry the delay before the next attempt
   * @param finder receives the lookup service, on a thread of the search
   */
  static LocatorSearch start(
      LookupLocator locator, Duration retry, Consumer<LocatedRegistrar> finder) {
    SharedLocatorSearch.User user = new SharedLocatorSearch.User(finder);
    return new LocatorSearch(locator, SharedLocatorSearch.join(locator, retry, user), user);
  }

  LookupLocator locator() {
    return locator;
  }

  /** The lookup service at the locator, as far as is known. */
  @Nullable LocatedRegistrar found() {
    return shared.found(user);
  }

  /** Searches again, if the lost lookup service is the found one. */
  void discard(LocatedRegistrar lost) {
    shared.discard(user, lost);
  }

  @Override
  public void close() {
    shared.leave(user);
  }
}
