package org.dfra.examples.recruit;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dfra.examples.recruit.Conversations.Attempt;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Arrival;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.message.SentMessage;
import org.jspecify.annotations.Nullable;

/**
 * The state of a call, derived from the messages sent.
 *
 * @param requester the calling robot
 * @param number counts the calls of all robots from 1
 * @param place where help is needed
 * @param since when its first message was sent, by its sender's clock
 * @param chosen the chosen helper, travelling or arrived; null before the choice
 * @param lost helpers that were chosen before and did not come, or left
 * @param rounds how often HELP was sent
 * @param messages number of messages; one to all counts as one
 * @param leaseEnd end of the lease that the chosen helper has granted, by its clock; null before
 */
record CallState(
    String requester,
    int number,
    GeoPosition place,
    Instant since,
    @Nullable String chosen,
    List<String> lost,
    int rounds,
    int messages,
    @Nullable Instant leaseEnd) {

  CallState {
    lost = List.copyOf(lost);
  }

  /**
   * The last call of a robot; empty if it has made none.
   *
   * @param all conversations, the first first
   */
  static Optional<CallState> last(List<Attempt> all, String requester) {
    Optional<Attempt> last =
        all.stream()
            .filter(each -> each.requester().equals(requester))
            .reduce((before, after) -> after);
    return last.map(newest -> of(all.stream().filter(each -> isSame(each, newest)).toList()));
  }

  private static boolean isSame(Attempt one, Attempt other) {
    return one.call() == other.call();
  }

  /** One call with at least one attempt; each attempt makes a new choice. */
  private static CallState of(List<Attempt> attempts) {
    Attempt last = attempts.get(attempts.size() - 1);
    Set<String> winners = new LinkedHashSet<>();
    @Nullable String chosen = null;
    @Nullable Instant stay = null;
    int rounds = 0;
    int envelopes = 0;
    for (Attempt attempt : attempts) {
      chosen = null;
      stay = null;
      for (SentMessage sent : attempt.messages()) {
        envelopes++;
        RecruitmentMessage message = sent.envelope().message();
        if (message instanceof Help) {
          rounds++;
        } else if (message instanceof ResponderId answer) {
          chosen = answer.winner();
          winners.add(chosen);
        } else if (message instanceof Arrival arrival) {
          stay = sent.measured().plus(arrival.stay());
        }
      }
    }
    winners.remove(chosen);
    return new CallState(
        last.requester(),
        last.call(),
        last.asked().position(),
        attempts.get(0).begun(),
        chosen,
        List.copyOf(winners),
        rounds,
        envelopes,
        stay);
  }

  /** Its duration until that time, seconds. */
  double seconds(Instant now) {
    return Duration.between(since, now).toMillis() / 1000.0;
  }
}
