package org.dfra.river.callback;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Counts the resources of one kind that clients hold, and refuses one more if a client or all of
 * them have reached their limit. Clients on this computer have a limit of their own, so that others
 * cannot exhaust it. Thread-safe.
 */
public final class PeerQuota {

  private final String what;
  private final QuotaLimits limits;

  // by other addresses
  @GuardedBy("this")
  private final Map<String, Integer> held = new HashMap<>();

  @GuardedBy("this")
  private int heldByOthers;

  @GuardedBy("this")
  private int heldByOwn;

  /**
   * The limits.
   *
   * @param perAddress for one client address, at least 1
   * @param remoteTotal for all other computers, at least as much
   * @param localTotal for this computer, at least 1
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
   * @param what the resource and its owner, as in "listeners of atrv1/gps"
   */
  public PeerQuota(String what, QuotaLimits limits) {
    this.what = what;
    this.limits = limits;
  }

  /**
   * Counts one more for a client.
   *
   * @return empty if it was counted; otherwise the reason why it was not, as a sentence
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

  /** Releases one that was counted for a client. */
  public synchronized void release(ClientAddress client) {
    if (client.isLocal()) {
      heldByOwn--;
    } else {
      held.computeIfPresent(client.host(), (host, count) -> count == 1 ? null : count - 1);
      heldByOthers--;
    }
  }

  /** The number held now, by all clients. */
  public synchronized int held() {
    return heldByOwn + heldByOthers;
  }
}
