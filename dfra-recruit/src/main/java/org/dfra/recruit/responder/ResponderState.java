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
 * The state of a responder. Immutable; stored across restarts of its process.
 *
 * @param phase of the responder
 * @param conversation that it takes part in; null while it is {@code FREE}
 * @param call of that conversation; null while it is {@code FREE}
 * @param sends number of transmissions of this phase's message since the last request
 * @param offers expiry of each of its offers, in the order of sending
 * @param again time of the next repetition; the far future where there is none
 * @param until time of its own withdrawal: the end of the offer that it was chosen for, or of its
 *     lease; the far future where neither binds it
 * @param lease the lease on itself; null before it has arrived
 * @param leaseEnd its end; the far future where there is none
 * @param ledgers record of each requester
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
    Map<String, ConversationRecord> ledgers)
    implements Serializable {

  /** Before the first call. */
  public static final ResponderState FREE = free(Map.of());

  public ResponderState {
    offers = List.copyOf(offers);
    ledgers = Map.copyOf(ledgers);
  }

  private static ResponderState free(Map<String, ConversationRecord> ledgers) {
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

  /** The next timeout; the far future where there is none. */
  public Instant nextWake() {
    return again.isBefore(until) ? again : until;
  }

  /** Remaining time of its stay, by its lease; not negative. */
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

  ConversationRecord record(Conversation of) {
    return ledgers.getOrDefault(of.requester(), ConversationRecord.EMPTY);
  }

  ResponderState remember(String requester, ConversationRecord record) {
    if (record.equals(ledgers.get(requester))) {
      return this;
    }
    Map<String, ConversationRecord> known = new HashMap<>(ledgers);
    known.put(requester, record);
    return withLedgers(known);
  }

  ResponderState close(Conversation over) {
    return remember(over.requester(), record(over).close(over.number()));
  }

  /** The state without timed commitments; the records of requesters stay. */
  public ResponderState afterAnotherBoot() {
    return conversation == null ? this : freed();
  }

  ResponderState freed() {
    return free(close(requireConversation()).ledgers);
  }

  ResponderState offered(
      Conversation in, HelpCall wanted, int messagesSent, Instant offer, Instant repeat) {
    List<Instant> all = new ArrayList<>(in.equals(conversation) ? offers : List.of());
    all.add(offer);
    return free(ledgers)
        .withConversation(in, wanted, all)
        .withPhase(ResponderPhase.OFFERED, messagesSent, repeat, Instant.MAX);
  }

  ResponderState travelling(Instant end) {
    return withLease(null, Instant.MAX).withPhase(ResponderPhase.TRAVELLING, 0, Instant.MAX, end);
  }

  /** The requester has extended its wait. */
  ResponderState extended(Instant end) {
    return withPhase(phase, sends, again, end);
  }

  ResponderState arrived(UUID granted, Instant end, Instant repeat) {
    return withLease(granted, end)
        .withPhase(ResponderPhase.ARRIVED, 1, repeat, until.isBefore(end) ? until : end);
  }

  ResponderState repeated(Instant repeat) {
    return withPhase(phase, sends + 1, repeat, until);
  }

  ResponderState leased() {
    return withPhase(ResponderPhase.LEASED, 0, Instant.MAX, leaseEnd);
  }

  /** The same lease with a new ID, as granted again after a restart of its process. */
  public ResponderState withLease(UUID granted) {
    return withLease(granted, leaseEnd);
  }

  /** A phase with the transmissions of its message, their repetition, and its own withdrawal. */
  private ResponderState withPhase(ResponderPhase at, int sent, Instant repeat, Instant end) {
    return new ResponderState(
        at, conversation, call, sent, offers, repeat, end, lease, leaseEnd, ledgers);
  }

  private ResponderState withConversation(Conversation in, HelpCall wanted, List<Instant> ends) {
    return new ResponderState(
        phase, in, wanted, sends, ends, again, until, lease, leaseEnd, ledgers);
  }

  private ResponderState withLease(@Nullable UUID granted, Instant end) {
    return new ResponderState(
        phase, conversation, call, sends, offers, again, until, granted, end, ledgers);
  }

  private ResponderState withLedgers(Map<String, ConversationRecord> known) {
    return new ResponderState(
        phase, conversation, call, sends, offers, again, until, lease, leaseEnd, known);
  }
}
