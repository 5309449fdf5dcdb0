package org.dfra.recruit.responder;

import java.io.Serializable;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.agent.ResponderPhase;
import org.dfra.recruit.message.Conversation;
import org.jspecify.annotations.Nullable;

/**
 * All that a responder knows. Immutable; kept over the death of its process.
 *
 * @param phase what it is at
 * @param conversation the one that it has a part in; null while it is {@code FREE}
 * @param call what is wanted there; null while it is {@code FREE}
 * @param sends how often it has said what it says in this phase, since it was last asked
 * @param offers until when each of its offers binds it, in the order in which they were sent
 * @param again when it says so again; the far future where it does not
 * @param until when it turns back by itself: the offer that it was chosen for, or its lease, is
 *     over; the far future where neither binds it
 * @param lease the lease on itself; null before it has arrived
 * @param leaseEnd when that ends; the far future where there is none
 * @param ledgers what it remembers of each requester
 */
public record ResponderState(
    ResponderPhase phase,
    @Nullable Conversation conversation,
    @Nullable HelpCall call,
    int sends,
    List<Instant> offers,
    Instant again,
    Instant until,
    @Nullable UUID lease,
    Instant leaseEnd,
    Map<String, Ledger> ledgers)
    implements Serializable {

  /** Before the first call. */
  public static final ResponderState FREE = free(Map.of());

  public ResponderState {
    offers = List.copyOf(offers);
    ledgers = Map.copyOf(ledgers);
  }

  private static ResponderState free(Map<String, Ledger> ledgers) {
    return new ResponderState(
        ResponderPhase.FREE,
        null,
        null,
        0,
        List.of(),
        Instant.MAX,
        Instant.MAX,
        null,
        Instant.MAX,
        ledgers);
  }

  /** When something is to be done though nothing happens; the far future where nothing is. */
  public Instant nextWake() {
    return again.isBefore(until) ? again : until;
  }

  /** For how long yet it can stay, by its lease; not negative. */
  public Duration remainingStay(Instant now) {
    return now.isBefore(leaseEnd) ? Duration.between(now, leaseEnd) : Duration.ZERO;
  }

  HelpCall requireCall() {
    if (call == null) {
      throw new IllegalStateException("a responder that is " + phase + " has no call");
    }
    return call;
  }

  Conversation requireConversation() {
    if (conversation == null) {
      throw new IllegalStateException("a responder that is " + phase + " has no conversation");
    }
    return conversation;
  }

  boolean isIn(Conversation other) {
    return other.equals(conversation);
  }

  Ledger ledger(Conversation of) {
    return ledgers.getOrDefault(of.requester(), Ledger.EMPTY);
  }

  private ResponderState with(Map<String, Ledger> known) {
    return new ResponderState(
        phase, conversation, call, sends, offers, again, until, lease, leaseEnd, known);
  }

  ResponderState remember(String requester, Ledger ledger) {
    if (ledger.equals(ledgers.get(requester))) {
      return this;
    }
    Map<String, Ledger> known = new HashMap<>(ledgers);
    known.put(requester, ledger);
    return with(known);
  }

  ResponderState close(Conversation over) {
    return remember(over.requester(), ledger(over).close(over.number()));
  }

  /** Without anything that a span binds it to; what it remembers of each requester stays. */
  public ResponderState afterAnotherBoot() {
    return conversation == null ? this : freed();
  }

  ResponderState freed() {
    return free(close(requireConversation()).ledgers);
  }

  ResponderState offered(
      Conversation in, HelpCall wanted, int said, Instant offer, Instant repeat) {
    List<Instant> all = new ArrayList<>(in.equals(conversation) ? offers : List.of());
    all.add(offer);
    return new ResponderState(
        ResponderPhase.OFFERED,
        in,
        wanted,
        said,
        all,
        repeat,
        Instant.MAX,
        null,
        Instant.MAX,
        ledgers);
  }

  ResponderState travelling(Instant end) {
    return new ResponderState(
        ResponderPhase.TRAVELLING,
        conversation,
        call,
        0,
        offers,
        Instant.MAX,
        end,
        null,
        Instant.MAX,
        ledgers);
  }

  /** The requester waits longer than it did. */
  ResponderState extended(Instant end) {
    return new ResponderState(
        phase, conversation, call, sends, offers, again, end, lease, leaseEnd, ledgers);
  }

  ResponderState arrived(UUID granted, Instant end, Instant repeat) {
    return new ResponderState(
        ResponderPhase.ARRIVED,
        conversation,
        call,
        1,
        offers,
        repeat,
        until.isBefore(end) ? until : end,
        granted,
        end,
        ledgers);
  }

  ResponderState repeated(Instant repeat) {
    return new ResponderState(
        phase, conversation, call, sends + 1, offers, repeat, until, lease, leaseEnd, ledgers);
  }

  ResponderState leased() {
    return new ResponderState(
        ResponderPhase.LEASED,
        conversation,
        call,
        0,
        offers,
        Instant.MAX,
        leaseEnd,
        lease,
        leaseEnd,
        ledgers);
  }

  /** The same lease under another name, as it is granted anew after its process died. */
  public ResponderState withLease(UUID granted) {
    return new ResponderState(
        phase, conversation, call, sends, offers, again, until, granted, leaseEnd, ledgers);
  }
}
