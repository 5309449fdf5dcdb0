package org.dfra.river.call;

import java.util.concurrent.ConcurrentHashMap;

/**
 * Counts, for each peer, the given-up calls whose threads JERI has not let go of yet.
 *
 * <p>A peer that is out of radio range can hold a connecting thread for minutes. Past {@link
 * #MAX_BLOCKED_THREADS} of them a further call is refused at once instead of costing one more
 * thread.
 */
final class UnresponsivePeers {

  /** Given-up calls to one peer that may hold a thread each. */
  static final int MAX_BLOCKED_THREADS = 16;

  private final ConcurrentHashMap<Object, Integer> held = new ConcurrentHashMap<>();

  /** How many given-up calls to this peer hold a thread. */
  int blockedThreads(Object peer) {
    return held.getOrDefault(peer, 0);
  }

  /** One more given-up call holds a thread. */
  void addBlockedThread(Object peer) {
    held.merge(peer, 1, Integer::sum);
  }

  /** One of them was let go. */
  void removeBlockedThread(Object peer) {
    held.computeIfPresent(peer, (key, count) -> count == 1 ? null : count - 1);
  }
}
