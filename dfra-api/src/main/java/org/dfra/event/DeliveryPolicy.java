package org.dfra.event;

import java.io.Serializable;
import java.util.Collection;
import java.util.EnumSet;
import java.util.Set;

/**
 * What one listener can take.
 *
 * @param kinds which kinds of event it wants; at least one
 * @param queueDepth events kept for it while it is busy, at least 1; past that the oldest are
 *     dropped and counted
 * @param maxRate deliveries per second at the most; between two, only the newest events are kept,
 *     {@code depth} of them; infinity for no limit
 */
public record DeliveryPolicy(Set<EventKind> kinds, int queueDepth, double maxRate)
    implements Serializable {

  /** Kinds of events. */
  public enum EventKind {
    READINESS,
    READING,
    PARAMETER,
    INCIDENT;

    /** The kind of an event. */
    public static EventKind of(ModuleEvent event) {
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
  public static final int MAX_QUEUE_DEPTH = 1024;

  public DeliveryPolicy {
    kinds = checked(kinds);
    if (kinds.isEmpty()) {
      throw new IllegalArgumentException("a listener that wants no kind of event needs none");
    }
    if (queueDepth < 1 || queueDepth > MAX_QUEUE_DEPTH) {
      throw new IllegalArgumentException(
          "depth " + queueDepth + " is outside 1 to " + MAX_QUEUE_DEPTH);
    }
    if (!(maxRate > 0)) {
      throw new IllegalArgumentException("rate " + maxRate + " Hz is not above 0");
    }
  }

  /**
   * Looks at each before any is hashed: what comes over the network may hold anything, also objects
   * whose hash codes take for ever.
   */
  private static Set<EventKind> checked(Collection<?> kinds) {
    Set<EventKind> all = EnumSet.noneOf(EventKind.class);
    int most = EventKind.values().length;
    for (Object each : kinds) {
      if (!(each instanceof EventKind kind) || most-- == 0) {
        throw new IllegalArgumentException(
            "a listener wants kinds of events, each once at the most; this one wants something else");
      }
      all.add(kind);
    }
    return Set.copyOf(all);
  }

  /** Every kind of event, the last {@code depth} kept while the listener is busy. */
  public static DeliveryPolicy keepLast(int depth) {
    return new DeliveryPolicy(EnumSet.allOf(EventKind.class), depth, Double.POSITIVE_INFINITY);
  }

  /** Only readings, and of those only the newest when the listener is busy. */
  public static DeliveryPolicy latestReading() {
    return new DeliveryPolicy(Set.of(EventKind.READING), 1, Double.POSITIVE_INFINITY);
  }

  /** The same at no more than so many deliveries per second. */
  public DeliveryPolicy withMaxRate(double hertz) {
    return new DeliveryPolicy(kinds, queueDepth, hertz);
  }

  /** The same for these kinds only. */
  public DeliveryPolicy withKinds(EventKind first, EventKind... others) {
    return new DeliveryPolicy(EnumSet.of(first, others), queueDepth, maxRate);
  }
}
