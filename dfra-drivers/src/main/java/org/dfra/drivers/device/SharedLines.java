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
public final class SharedLines<M extends LineMember, S extends SharedLine<M>> {

  /** A link is one for the time it lives by: simulated links may have the same name. */
  private record Key(String place, Ticker ticker) {}

  private final Map<Key, S> open = new HashMap<>(); // guarded by itself

  /**
   * Joins the modules of a link; opens it for the first.
   *
   * @param place of the link: the same for the same device
   * @param ticker the time that the link lives by
   * @param make makes the line, where there is none yet
   * @param agree throws where the module cannot share a line with the others, which then goes on
   *     without it
   */
  public S join(M member, String place, Ticker ticker, Supplier<S> make, Consumer<S> agree) {
    synchronized (open) {
      S found = open.computeIfAbsent(new Key(place, ticker), absent -> make.get());
      agree.accept(found);
      found.members().add(member);
      found.start();
      return found;
    }
  }

  void leave(M member, SharedLine<M> line) {
    synchronized (open) {
      if (!line.members().remove(member)) {
        return;
      }
      open.values().removeIf(each -> each == line);
    }
    line.close();
  }
}
