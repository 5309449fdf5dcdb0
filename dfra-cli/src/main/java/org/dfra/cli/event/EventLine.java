package org.dfra.cli.event;

import java.time.Instant;
import java.util.Locale;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.report.terminal.InlineFormat;

/**
 * An event in JSON output.
 *
 * @param module the module's path, {@code robot/name}
 * @param time when the module published it, by its own clock
 * @param kind its kind
 * @param sequence its number among those of its kind
 * @param epoch counts the module's restarts
 * @param lost events lost between the last received one and this one
 * @param type the type of the reading, or of the event
 * @param event the reading itself, or the event
 */
record EventLine(
    String module,
    Instant time,
    EventKind kind,
    long sequence,
    long epoch,
    long lost,
    String type,
    Object event) {

  static EventLine of(Delivery delivery, long lost) {
    Object event =
        delivery.event() instanceof ModuleEvent.NewReading reading
            ? reading.reading()
            : delivery.event();
    return new EventLine(
        delivery.module(),
        delivery.published(),
        delivery.kind(),
        delivery.sequence(),
        delivery.epoch(),
        lost,
        event.getClass().getSimpleName(),
        event);
  }

  /** The same as text output. */
  String inWords() {
    return String.format(
            Locale.ROOT,
            "%tFT%<tT.%<tLZ  %-9s  #%d  %s",
            time.atOffset(java.time.ZoneOffset.UTC),
            kind.name().toLowerCase(Locale.ROOT),
            sequence,
            what())
        + (lost == 0 ? "" : "  (" + lost + " lost before)");
  }

  private String what() {
    if (event instanceof ModuleEvent.ReadinessChanged change) {
      return word(change.from()) + " -> " + word(change.to());
    } else if (event instanceof ModuleEvent.ParameterChanged parameter) {
      return parameter.name() + " is now " + parameter.text();
    } else if (event instanceof ModuleEvent.IncidentRecorded noted) {
      return word(noted.incident().kind()) + ": " + noted.incident().description();
    }
    return type + " " + InlineFormat.of(event);
  }

  private static String word(Enum<?> constant) {
    return constant.name().toLowerCase(Locale.ROOT);
  }
}
