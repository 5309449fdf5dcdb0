package org.dfra.event;

import java.io.Serializable;
import java.util.Collection;
import java.util.EnumSet;
import java.util.Set;

/**
 * Which events one listener receives, and how many are queued for it.
 *
 * @param kinds the kinds of event that it receives; at least one
 * @param queueDepth events kept for it while it is busy, at least 1; beyond that the oldest are
 *     dropped and counted
 * @param maxRate maximum deliveries per second; between two, only the newest {@code queueDepth}
 *     events are kept; infinity for no limit
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
      throw new IllegalArgumentException(
          "no kinds of events are given; give one or more, or add no listener");
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
   * Checks each element's type before hashing any: a collection from the network may contain any
   * object, even one whose hash code takes forever.
   */
  private static Set<EventKind> checked(Collection<?> kinds) {
    Set<EventKind> all = EnumSet.noneOf(EventKind.class);
    int most = EventKind.values().length;
    for (Object each : kinds) {
      if (!(each instanceof EventKind kind) || most-- == 0) {
        throw new IllegalArgumentException(
            "a listener names kinds of events, each once at the most; this one names something else");
      }
      all.add(kind);
    }
    return Set.copyOf(all);
  }

  /** Every kind of event, the last {@code depth} kept while the listener is busy. */
  public static DeliveryPolicy keepLast(int depth) {
    return new DeliveryPolicy(EnumSet.allOf(EventKind.class), depth, Double.POSITIVE_INFINITY);
  }

  /** Only readings, and only the newest one while the listener is busy. */
  public static DeliveryPolicy latestReading() {
    return new DeliveryPolicy(Set.of(EventKind.READING), 1, Double.POSITIVE_INFINITY);
  }

  /** The same with at most this many deliveries per second. */
  public DeliveryPolicy withMaxRate(double hertz) {
    return new DeliveryPolicy(kinds, queueDepth, hertz);
  }

  /** The same for these kinds only. */
  public DeliveryPolicy withKinds(EventKind first, EventKind... others) {
    return new DeliveryPolicy(EnumSet.of(first, others), queueDepth, maxRate);
  }
}
