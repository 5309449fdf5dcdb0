package org.dfra.drivers.device;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dfra.drivers.link.Ticker;

/**
 * The links of one protocol that modules of this virtual machine share. Safe for use by several
 * threads.
 *
 * @param <M> interface through which the protocol notifies and queries its clients
 * @param <S> the protocol's shared link
 */
public final class SharedLinkRegistry<M extends SharedLinkClient, S extends SharedDeviceLink<M>> {

  /** Links of different clocks are distinct: simulated links may have the same name. */
  private record Key(String linkKey, Ticker ticker) {}

  private final Map<Key, S> open = new HashMap<>(); // guarded by itself

  /**
   * Joins a shared link; opens it for the first module.
   *
   * @param linkKey key of the link: the same for the same device
   * @param ticker the clock of the link
   * @param factory makes the link if there is none yet
   * @param compatibilityCheck throws if the module cannot share the link with the others; they keep
   *     it
   */
  public S join(
      M client,
      String linkKey,
      Ticker ticker,
      Supplier<S> factory,
      Consumer<S> compatibilityCheck) {
    synchronized (open) {
      S found = open.computeIfAbsent(new Key(linkKey, ticker), absent -> factory.get());
      compatibilityCheck.accept(found);
      found.clients().add(client);
      found.start();
      return found;
    }
  }

  void leave(M client, SharedDeviceLink<M> link) {
    synchronized (open) {
      if (!link.clients().remove(client)) {
        return;
      }
      open.values().removeIf(each -> each == link);
    }
    link.close();
  }
}
