package org.dfra.river.callback;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Counts what clients hold of one thing, and refuses one more where a client or all of them hold as
 * much as they may. Clients on this computer have a bound of their own, so that others cannot use
 * it up. Thread-safe.
 */
public final class PeerQuota {

  private final String what;
  private final QuotaLimits limits;
  private final Map<String, Integer> held = new HashMap<>(); // guarded by this; by other addresses
  private int heldByOthers; // guarded by this
  private int heldByOwn; // guarded by this

  /**
   * How much may be held.
   *
   * @param perAddress by one client address, at least 1
   * @param remoteTotal by all other computers, at least as much
   * @param localTotal by this computer, at least 1
   */
  public record QuotaLimits(int perAddress, int remoteTotal, int localTotal) {
    public QuotaLimits {
      if (perAddress < 1 || remoteTotal < perAddress || localTotal < 1) {
        throw new IllegalArgumentException(
            "limits must be 1 <= perAddress %d <= others %d, and 1 <= own %d"
                .formatted(perAddress, remoteTotal, localTotal));
      }
    }
  }

  /**
   * @param what what is held and of whom, as in "listeners of atrv1/gps"
   */
  public PeerQuota(String what, QuotaLimits limits) {
    this.what = what;
    this.limits = limits;
  }

  /**
   * Counts one more for a client.
   *
   * @return nothing if it was counted; else why not, in a sentence, and it was not counted
   */
  public synchronized Optional<String> acquire(ClientAddress client) {
    if (client.isLocal()) {
      if (heldByOwn >= limits.localTotal()) {
        return full("this computer holds", heldByOwn, limits.localTotal());
      }
      heldByOwn++;
      return Optional.empty();
    }
    int its = held.getOrDefault(client.host(), 0);
    if (its >= limits.perAddress()) {
      return full(client.host() + " holds", its, limits.perAddress());
    }
    if (heldByOthers >= limits.remoteTotal()) {
      return full("other computers hold", heldByOthers, limits.remoteTotal());
    }
    held.put(client.host(), its + 1);
    heldByOthers++;
    return Optional.empty();
  }

  private Optional<String> full(String who, int count, int limit) {
    return Optional.of(
        "%s: %s %d of at most %d; close some of them first, or wait until their leases end"
            .formatted(what, who, count, limit));
  }

  /** A client does not hold one any more that was counted for it. */
  public synchronized void release(ClientAddress client) {
    if (client.isLocal()) {
      heldByOwn--;
    } else {
      held.computeIfPresent(client.host(), (host, count) -> count == 1 ? null : count - 1);
      heldByOthers--;
    }
  }

  /** How much is held now, by all. */
  public synchronized int held() {
    return heldByOwn + heldByOthers;
  }
}
