package org.dfra.recruit.requester;

import java.io.Serializable;
import java.time.Instant;
import java.util.List;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RequesterPhase;
import org.dfra.recruit.message.Conversation;
import org.jspecify.annotations.Nullable;

/**
 * The state of a requester. Immutable; stored across restarts of its process.
 *
 * @param phase of the requester
 * @param conversation the last one started, or the one before the first
 * @param call current or last call; null before the first
 * @param round number of calls in the conversation; 0 while it waits until the previous helper is
 *     free
 * @param bids offers in the conversation; empty before and after {@code COLLECTING}
 * @param winner robot chosen in the conversation; null where none was
 * @param due next timeout of the call; the far future where there is none
 * @param until end of the wait for the winner, {@code AWARDED}, or of the lease
 * @param patience end of the search for a helper
 * @param farewell released helper without an acknowledgement yet; null for none
 */
public record RequesterState(
    RequesterPhase phase,
    Conversation conversation,
    @Nullable HelpCall call,
    int round,
    List<Bid> bids,
    @Nullable Bid winner,
    Instant due,
    Instant until,
    Instant patience,
    @Nullable PendingRelease farewell)
    implements Serializable {

  public RequesterState {
    bids = List.copyOf(bids);
  }

  /** Before the first call; the next conversation's number is greater than that of {@code last}. */
  public static RequesterState idle(Conversation last) {
    return new RequesterState(
        RequesterPhase.IDLE,
        last,
        null,
        0,
        List.of(),
        null,
        Instant.MAX,
        Instant.MAX,
        Instant.MAX,
        null);
  }

  /** The next timeout; the far future where there is none. */
  public Instant nextWake() {
    Instant reported = farewell == null ? Instant.MAX : farewell.again();
    return reported.isBefore(due) ? reported : due;
  }

  HelpCall requireCall() {
    if (call == null) {
      throw new IllegalStateException(conversation + " is " + phase + " and has no call");
    }
    return call;
  }

  Bid requireWinner() {
    if (winner == null) {
      throw new IllegalStateException(conversation + " is " + phase + " and has no chosen robot");
    }
    return winner;
  }

  boolean isWinner(String robot) {
    return winner != null && winner.robot().equals(robot);
  }

  RequesterState open(Conversation next, HelpCall wanted, Instant end, Instant again) {
    return idle(next).withPendingRelease(farewell).withCall(wanted, end).calling(1, again);
  }

  /** The same call, not sent yet: the previous helper may not be free. */
  RequesterState waiting(Instant free) {
    return calling(0, free);
  }

  /** Whether the call is not sent yet. */
  boolean isWaiting() {
    return phase == RequesterPhase.CALLING && round == 0;
  }

  RequesterState calling(int rounds, Instant again) {
    return withRound(rounds).withPhase(RequesterPhase.CALLING, List.of(), null, again, Instant.MAX);
  }

  RequesterState collecting(List<Bid> known, Instant end) {
    return withPhase(RequesterPhase.COLLECTING, known, null, end, Instant.MAX);
  }

  /**
   * @param release time to release the winner, which has not arrived
   */
  RequesterState awarded(Bid chosen, Instant release, Instant end) {
    return helped(RequesterPhase.AWARDED, chosen, release.isBefore(end) ? release : end, end);
  }

  RequesterState onSite(Instant again, Instant end) {
    return helped(RequesterPhase.ON_SITE, requireWinner(), again.isBefore(end) ? again : end, end);
  }

  RequesterState done() {
    return helped(RequesterPhase.BEING_HELPED, requireWinner(), until, until);
  }

  private RequesterState helped(RequesterPhase at, Bid by, Instant next, Instant end) {
    return withPhase(at, List.of(), by, next, end);
  }

  RequesterState ended() {
    return withCall(call, Instant.MAX)
        .withPhase(RequesterPhase.IDLE, List.of(), winner, Instant.MAX, Instant.MAX);
  }

  /** Another phase of the same call, with what belongs to a phase. */
  private RequesterState withPhase(
      RequesterPhase at, List<Bid> known, @Nullable Bid chosen, Instant next, Instant end) {
    return new RequesterState(
        at, conversation, call, round, known, chosen, next, end, patience, farewell);
  }

  private RequesterState withCall(@Nullable HelpCall wanted, Instant end) {
    return new RequesterState(
        phase, conversation, wanted, round, bids, winner, due, until, end, farewell);
  }

  private RequesterState withRound(int rounds) {
    return new RequesterState(
        phase, conversation, call, rounds, bids, winner, due, until, patience, farewell);
  }

  RequesterState withPendingRelease(@Nullable PendingRelease from) {
    return new RequesterState(
        phase, conversation, call, round, bids, winner, due, until, patience, from);
  }
}
