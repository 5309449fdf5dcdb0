package org.dfra.recruit.requester;

import java.io.Serializable;
import java.time.Instant;
import java.util.List;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RequesterPhase;
import org.dfra.recruit.message.Conversation;
import org.jspecify.annotations.Nullable;

/**
 * All that a requester knows. Immutable; kept over the death of its process.
 *
 * @param phase what it is at
 * @param conversation the last that it began, or the one before the first
 * @param call what help it wants or wanted; null before the first
 * @param round how often it called in the conversation; 0 while it waits with that until the helper
 *     before is free
 * @param bids who offered in the conversation; empty before and after {@code COLLECTING}
 * @param winner who was chosen in the conversation; null where nobody was
 * @param due when something is to be done for the call though nothing happens; the far future where
 *     nothing is
 * @param until until when it waits for the winner to come, {@code AWARDED}, or the lease lasts
 * @param patience until when it looks for somebody
 * @param farewell who was let go and does not know yet; null where nobody was
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
    @Nullable Farewell farewell)
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

  /** When something is to be done though nothing happens; the far future where nothing is. */
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
      throw new IllegalStateException(conversation + " is " + phase + " and chose nobody");
    }
    return winner;
  }

  boolean isWinner(String robot) {
    return winner != null && winner.robot().equals(robot);
  }

  RequesterState open(Conversation next, HelpCall wanted, Instant end, Instant again) {
    return new RequesterState(
        RequesterPhase.CALLING,
        next,
        wanted,
        1,
        List.of(),
        null,
        again,
        Instant.MAX,
        end,
        farewell);
  }

  /** The same call, which asks nobody yet: the helper before may not be free. */
  RequesterState waiting(Instant free) {
    return calling(0, free);
  }

  /** Whether it asks nobody yet. */
  boolean isWaiting() {
    return phase == RequesterPhase.CALLING && round == 0;
  }

  RequesterState calling(int rounds, Instant again) {
    return new RequesterState(
        RequesterPhase.CALLING,
        conversation,
        call,
        rounds,
        List.of(),
        null,
        again,
        Instant.MAX,
        patience,
        farewell);
  }

  RequesterState collecting(List<Bid> known, Instant end) {
    return new RequesterState(
        RequesterPhase.COLLECTING,
        conversation,
        call,
        round,
        known,
        null,
        end,
        Instant.MAX,
        patience,
        farewell);
  }

  /**
   * @param release when the winner, which has not come, is released
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
    return new RequesterState(
        at, conversation, call, round, List.of(), by, next, end, patience, farewell);
  }

  RequesterState ended() {
    return new RequesterState(
        RequesterPhase.IDLE,
        conversation,
        call,
        round,
        List.of(),
        winner,
        Instant.MAX,
        Instant.MAX,
        Instant.MAX,
        farewell);
  }

  RequesterState withPendingRelease(@Nullable Farewell from) {
    return new RequesterState(
        phase, conversation, call, round, bids, winner, due, until, patience, from);
  }
}
