package org.dfra.river.transport;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.HashMap;
import java.util.Map;

/**
 * How much of this virtual machine the clients at one address, and all of them, may use. Processes
 * of the own user, which connect by a Unix-domain socket, are limited only all together, and a
 * quarter of everything is kept for them. Thread-safe.
 */
final class ConnectionLimits {

  /** What is limited. */
  enum Resource {
    /** Open connections; beyond, the one that was idle longest is closed. */
    CONNECTIONS(512, 2048),
    /** Threads that read, execute or answer a call; beyond, the call is refused. */
    WORKERS(128, 512),
    /** Threads that keep a connection between calls; beyond, the selector waits. */
    WAITING_WORKERS(32, 128),
    /** Threads that wait for the rest of a call; beyond, the call is refused. */
    RECEIVERS(32, 64),
    /** Bytes of calls that have only arrived in part; beyond, the connection is closed. */
    PARTIAL_BYTES(1 << 20, 4 << 20);

    private final int perAddress;
    private final int total;

    Resource(int perAddress, int total) {
      this.perAddress = perAddress;
      this.total = total;
    }

    private int totalOfOthers() {
      return total / 4 * 3;
    }
  }

  private static final int KINDS = Resource.values().length;

  @GuardedBy("this")
  private final Map<Object, int[]> used = new HashMap<>(); // by origin

  @GuardedBy("this")
  private final int[] totals = new int[KINDS];

  @GuardedBy("this")
  private final int[] totalsOfOthers = new int[KINDS];

  /**
   * Takes some of a resource.
   *
   * @return false if the limit would be exceeded; then nothing was taken
   */
  synchronized boolean take(Resource resource, Peer peer, int count) {
    int kind = resource.ordinal();
    int[] its = used.computeIfAbsent(peer.origin(), unused -> new int[KINDS]);
    boolean isFree =
        totals[kind] + count <= resource.total
            && (peer.isLocalUser()
                || (its[kind] + count <= resource.perAddress
                    && totalsOfOthers[kind] + count <= resource.totalOfOthers()));
    if (isFree) {
      add(resource, peer, its, count);
    }
    forgetUnused(peer, its);
    return isFree;
  }

  /** Whether a peer has its whole share of a resource; otherwise only all together may have. */
  synchronized boolean isExhausted(Resource resource, Peer peer) {
    int[] its = used.get(peer.origin());
    return !peer.isLocalUser() && its != null && its[resource.ordinal()] >= resource.perAddress;
  }

  /** Gives back what was taken. */
  synchronized void giveBack(Resource resource, Peer peer, int count) {
    int[] its = used.get(peer.origin());
    if (its == null || its[resource.ordinal()] < count) {
      throw new IllegalStateException(peer + " gives back more " + resource + " than it took");
    }
    add(resource, peer, its, -count);
    forgetUnused(peer, its);
  }

  /** How much of a resource all clients use. */
  synchronized int total(Resource resource) {
    return totals[resource.ordinal()];
  }

  @GuardedBy("this")
  private void add(Resource resource, Peer peer, int[] its, int count) {
    int kind = resource.ordinal();
    its[kind] += count;
    totals[kind] += count;
    if (!peer.isLocalUser()) {
      totalsOfOthers[kind] += count;
    }
  }

  @GuardedBy("this")
  private void forgetUnused(Peer peer, int[] its) {
    for (int each : its) {
      if (each > 0) {
        return;
      }
    }
    used.remove(peer.origin());
  }
}
