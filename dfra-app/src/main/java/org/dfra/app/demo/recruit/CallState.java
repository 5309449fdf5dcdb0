package org.dfra.app.demo.recruit;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dfra.app.demo.recruit.Conversations.Attempt;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Arrival;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.message.SentMessage;
import org.jspecify.annotations.Nullable;

/**
 * How a call is going, by the letters that were sent.
 *
 * @param requester who calls
 * @param number counts the calls of all robots from 1
 * @param place where help is needed
 * @param since when the first letter of it was sent, by its sender's clock
 * @param chosen who is to come, or has come; null where nobody was chosen yet
 * @param lost who was chosen before and did not come, or left
 * @param rounds how often HELP was sent
 * @param messages how many were sent, one to all counted as one
 * @param leaseEnd when the lease ends that the chosen one has granted, by its clock; null before
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
   * The call that a robot has made last; nothing where it has made none.
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

  /** Of one call, with an attempt at least; each attempt chooses anew. */
  private static CallState of(List<Attempt> attempts) {
    Attempt last = attempts.get(attempts.size() - 1);
    Set<String> winners = new LinkedHashSet<>();
    @Nullable String chosen = null;
    @Nullable Instant stay = null;
    int rounds = 0;
    int letters = 0;
    for (Attempt attempt : attempts) {
      chosen = null;
      stay = null;
      for (SentMessage sent : attempt.messages()) {
        letters++;
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
        letters,
        stay);
  }

  /** For how many seconds it has been under way at that time. */
  double seconds(Instant now) {
    return Duration.between(since, now).toMillis() / 1000.0;
  }
}
