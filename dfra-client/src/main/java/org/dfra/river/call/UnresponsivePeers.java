package org.dfra.river.call;

import java.util.concurrent.ConcurrentHashMap;

/**
 * Counts, for each peer, the abandoned calls whose threads JERI still blocks.
 *
 * <p>A peer that is out of radio range can block a connecting thread for minutes. Beyond {@link
 * #MAX_BLOCKED_THREADS} such threads, a further call is refused immediately instead of blocking one
 * more.
 */
final class UnresponsivePeers {

  /** The maximum number of threads that abandoned calls to one peer may block. */
  static final int MAX_BLOCKED_THREADS = 16;

  private final ConcurrentHashMap<Object, Integer> held = new ConcurrentHashMap<>();

  /** The number of threads that abandoned calls to this peer block. */
  int blockedThreads(Object peer) {
    return held.getOrDefault(peer, 0);
  }

  /** Adds a blocked thread. */
  void addBlockedThread(Object peer) {
    held.merge(peer, 1, Integer::sum);
  }

  /** Removes a blocked thread. */
  void removeBlockedThread(Object peer) {
    held.computeIfPresent(peer, (key, count) -> count == 1 ? null : count - 1);
  }
}
