package org.dfra.drivers.device;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dfra.drivers.link.Ticker;

/**
 * The lines of one protocol that modules of this virtual machine share. Safe for use by several
 * threads.
 *
 * @param <M> what the protocol tells its members and asks of them
 * @param <S> the protocol's line
 */
public final class SharedLinkRegistry<M extends SharedLinkClient, S extends SharedDeviceLink<M>> {

  /** A link is one for the time it lives by: simulated links may have the same name. */
  private record Key(String linkKey, Ticker ticker) {}

  private final Map<Key, S> open = new HashMap<>(); // guarded by itself

  /**
   * Joins the modules of a link; opens it for the first.
   *
   * @param linkKey of the link: the same for the same device
   * @param ticker the time that the link lives by
   * @param factory makes the line, where there is none yet
   * @param compatibilityCheck throws where the module cannot share a line with the others, which
   *     then goes on without it
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
