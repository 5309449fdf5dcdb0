package org.dfra.event;

import java.io.Serializable;
import java.util.Collection;
import java.util.EnumSet;
import java.util.Set;

/**
 * What one listener can take.
 *
 * @param kinds which kinds of event it wants; at least one
 * @param depth events kept for it while it is busy, at least 1; past that the oldest are dropped
 *     and counted
 * @param highestRate deliveries per second at the most; between two, only the newest events are
 *     kept, {@code depth} of them; infinity for no limit
 */
public record DeliveryPolicy(Set<Kind> kinds, int depth, double highestRate)
    implements Serializable {

  /** Kinds of events. */
  public enum Kind {
    READINESS,
    READING,
    PARAMETER,
    INCIDENT;

    /** The kind of an event. */
    public static Kind of(ModuleEvent event) {
      if (event instanceof ModuleEvent.NewReading) {
        return READING;
      } else if (event instanceof ModuleEvent.ReadinessChanged) {
        return READINESS;
      } else if (event instanceof ModuleEvent.ParameterChanged) {
        return PARAMETER;
      } else {
        return INCIDENT;
      }
    }
  }

  /** The most events that may be kept for one listener. */
  public static final int DEEPEST = 1024;

  public DeliveryPolicy {
    kinds = checked(kinds);
    if (kinds.isEmpty()) {
      throw new IllegalArgumentException("a listener that wants no kind of event needs none");
    }
    if (depth < 1 || depth > DEEPEST) {
      throw new IllegalArgumentException("depth " + depth + " is outside 1 to " + DEEPEST);
    }
    if (!(highestRate > 0)) {
      throw new IllegalArgumentException("rate " + highestRate + " Hz is not above 0");
    }
  }

  /**
   * Looks at each before any is hashed: what comes over the network may hold anything, also objects
   * whose hash codes take for ever.
   */
  private static Set<Kind> checked(Collection<?> kinds) {
    Set<Kind> all = EnumSet.noneOf(Kind.class);
    int most = Kind.values().length;
    for (Object each : kinds) {
      if (!(each instanceof Kind kind) || most-- == 0) {
        throw new IllegalArgumentException(
            "a listener wants kinds of events, each once at the most; this one wants something else");
      }
      all.add(kind);
    }
    return Set.copyOf(all);
  }

  /** Every kind of event, the last {@code depth} kept while the listener is busy. */
  public static DeliveryPolicy keepLast(int depth) {
    return new DeliveryPolicy(EnumSet.allOf(Kind.class), depth, Double.POSITIVE_INFINITY);
  }

  /** Only readings, and of those only the newest when the listener is busy. */
  public static DeliveryPolicy latestReading() {
    return new DeliveryPolicy(Set.of(Kind.READING), 1, Double.POSITIVE_INFINITY);
  }

  /** The same at no more than so many deliveries per second. */
  public DeliveryPolicy atMost(double hertz) {
    return new DeliveryPolicy(kinds, depth, hertz);
  }

  /** The same for these kinds only. */
  public DeliveryPolicy only(Kind first, Kind... others) {
    return new DeliveryPolicy(EnumSet.of(first, others), depth, highestRate);
  }
}
