package org.dfra.river.registrar;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Supplier;
import net.jini.core.event.RemoteEvent;
import net.jini.core.lookup.ServiceEvent;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.security.Visibility;
import org.jspecify.annotations.Nullable;

/**
 * The events of a listener from whose owner something may be hidden. Reggie's events only say which
 * service may have changed. What the owner sees of it now is compared with what it saw before: that
 * gives the transition and the item that are sent, or nothing. So a change of what is hidden causes
 * no event, and a template matches what is seen. The sequence numbers have no gaps for events that
 * are not sent.
 *
 * <p>While nothing is hidden, the events are passed on as they are.
 */
final class VisibleEvents implements EventFilter {

  private final VisibleLookup lookup;
  private final ReggieItems items;
  private final Object template;
  private final int transitions;
  private final Supplier<Visibility> visibility;

  /** What was seen last of each service that matched; their values are those of reggie. */
  @GuardedBy("this")
  private final Map<ServiceID, Object> matching = new HashMap<>();

  @GuardedBy("this")
  private long notSent;

  /**
   * @param transitions that the owner asked for
   * @param visibility what the owner sees at present
   */
  VisibleEvents(
      VisibleLookup lookup,
      ReggieItems items,
      Object template,
      int transitions,
      Supplier<Visibility> visibility) {
    this.lookup = lookup;
    this.items = items;
    this.template = template;
    this.transitions = transitions;
    this.visibility = visibility;
  }

  /** Looks at what matches before the listener is registered. */
  synchronized VisibleEvents started() {
    for (Object each : lookup.matching(template, visibility.get())) {
      matching.put(items.serviceId(each), each);
    }
    return this;
  }

  @Override
  public synchronized @Nullable RemoteEvent filtered(RemoteEvent event) {
    if (!(event instanceof ServiceEvent of)) {
      return null; // reggie sends no others
    }
    Visibility now = visibility.get();
    if (now.isComplete()) {
      return passed(of);
    }
    ServiceID service = of.getServiceID();
    @Nullable Object seen = lookup.matching(service, template, now);
    if (seen == null) {
      return matching.remove(service) == null
          ? notSent()
          : sent(of, ServiceRegistrar.TRANSITION_MATCH_NOMATCH, null);
    }
    @Nullable Object before = matching.put(service, seen);
    if (before == null) {
      return sent(of, ServiceRegistrar.TRANSITION_NOMATCH_MATCH, seen);
    }
    return items.isSame(before, seen)
        ? notSent()
        : sent(of, ServiceRegistrar.TRANSITION_MATCH_MATCH, seen);
  }

  /** The event of a policy that hides nothing; reggie was perhaps asked for all transitions. */
  @GuardedBy("this")
  private @Nullable RemoteEvent passed(ServiceEvent event) {
    if ((event.getTransition() & transitions) == 0) {
      return notSent();
    }
    return notSent == 0
        ? event
        : items.event(
            event,
            event.getSequenceNumber() - notSent,
            event.getTransition(),
            items.sentItem(event));
  }

  @GuardedBy("this")
  private @Nullable RemoteEvent sent(ServiceEvent event, int transition, @Nullable Object seen) {
    if ((transition & transitions) == 0) {
      return notSent();
    }
    return items.event(
        event,
        event.getSequenceNumber() - notSent,
        transition,
        seen == null ? null : items.sent(seen));
  }

  @GuardedBy("this")
  private @Nullable RemoteEvent notSent() {
    notSent++;
    return null;
  }
}
