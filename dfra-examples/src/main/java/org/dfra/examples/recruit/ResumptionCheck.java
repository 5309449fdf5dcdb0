package org.dfra.examples.recruit;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.ResponderPhase;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.jspecify.annotations.Nullable;

/**
 * Checks whether a recruited robot had been searching, left that search to help, and resumed the
 * same search until it made progress. All times are by the robot's clock.
 */
final class ResumptionCheck {

  /**
   * One period in which the robot was away to help.
   *
   * @param asked when it had not left its work yet: it offered, or else departed
   * @param free when it was free again; null if not yet
   */
  private record Absence(Instant asked, @Nullable Instant free) {}

  /**
   * A fault.
   *
   * @param hadSearched whether the robot had been searching when it was recruited
   * @param why a clause about the robot
   */
  record ResumptionFault(boolean hadSearched, String why) {}

  private ResumptionCheck() {}

  /**
   * The first fault; empty if the robot resumed each time, or never helped.
   *
   * @param agent statuses of its agent, in the order received
   * @param search statuses of its search, in the order received
   */
  static Optional<ResumptionFault> fault(
      List<RecruitmentStatus> agent, List<BehaviorStatus> search) {
    List<Absence> separation = new ArrayList<>();
    for (Absence each : absences(agent)) {
      Absence before = separation.isEmpty() ? null : separation.get(separation.size() - 1);
      if (before != null && isStillAway(before, each, search)) {
        separation.set(separation.size() - 1, new Absence(before.asked(), each.free()));
      } else {
        separation.add(each);
      }
    }
    return separation.stream().flatMap(each -> fault(each, search).stream()).findFirst();
  }

  /** Whether it was recruited again before it was back at its search: that is one absence. */
  private static boolean isStillAway(Absence before, Absence next, List<BehaviorStatus> search) {
    Instant free = before.free();
    return free != null
        && at(next.asked(), search).filter(each -> each.phase() == Phase.PAUSED).isPresent()
        && search.stream()
            .filter(each -> isIn(free, each) && !each.measured().isAfter(next.asked()))
            .noneMatch(each -> each.phase() == Phase.RUNNING);
  }

  /** The last status at that time. */
  private static Optional<BehaviorStatus> at(Instant time, List<BehaviorStatus> search) {
    return search.stream()
        .filter(each -> !each.measured().isAfter(time))
        .reduce((first, second) -> second);
  }

  private static List<Absence> absences(List<RecruitmentStatus> agent) {
    List<Absence> all = new ArrayList<>();
    @Nullable Instant offered = null;
    @Nullable Instant asked = null;
    for (RecruitmentStatus each : agent) {
      if (each.responderPhase() == ResponderPhase.OFFERED) {
        offered = offered == null ? each.measured() : offered;
      } else if (each.responderPhase().isCommitted()) {
        asked = asked != null ? asked : offered != null ? offered : each.measured();
      } else {
        if (asked != null) {
          all.add(new Absence(asked, each.measured()));
        }
        offered = null;
        asked = null;
      }
    }
    if (asked != null) {
      all.add(new Absence(asked, null));
    }
    return all;
  }

  private static Optional<ResumptionFault> fault(Absence away, List<BehaviorStatus> search) {
    BehaviorStatus before = at(away.asked(), search).orElse(null);
    if (before == null || before.phase() != Phase.RUNNING) {
      return Optional.of(
          new ResumptionFault(
              false,
              "was not searching when it was recruited: "
                  + (before == null
                      ? "it had no search"
                      : "its search was " + before.phase() + ", " + before.activity())));
    }
    Instant free = away.free();
    if (free == null) {
      return notResumed("was recruited and is not free again");
    }
    List<BehaviorStatus> same =
        search.stream().filter(each -> Objects.equals(each.goal(), before.goal())).toList();
    if (same.stream().noneMatch(each -> isIn(away.asked(), each) && each.phase() == Phase.PAUSED)) {
      return notResumed("never interrupted its search to help");
    }
    return wentOn(free, same, search.get(search.size() - 1));
  }

  private static boolean isIn(Instant from, BehaviorStatus each) {
    return !each.measured().isBefore(from);
  }

  /**
   * @param same statuses of the search that it left
   * @param last the last status of any search
   */
  private static Optional<ResumptionFault> wentOn(
      Instant free, List<BehaviorStatus> same, BehaviorStatus last) {
    double left =
        same.stream()
            .filter(each -> each.measured().isBefore(free))
            .mapToDouble(BehaviorStatus::completion)
            .max()
            .orElse(0);
    List<BehaviorStatus> after = same.stream().filter(each -> isIn(free, each)).toList();
    boolean hasRisen =
        after.stream().anyMatch(each -> each.phase() == Phase.RUNNING && each.completion() > left);
    if (hasRisen || after.stream().anyMatch(each -> each.phase() == Phase.SUCCEEDED)) {
      return Optional.empty();
    }
    if (!Objects.equals(last.goal(), same.get(0).goal())) {
      return notResumed("started another search instead of the one that it had interrupted");
    }
    return notResumed(
        last.phase() == Phase.RUNNING
            ? String.format(
                Locale.ROOT,
                "searches again, but not beyond the %.0f %% at which it interrupted its search",
                100 * left)
            : "has not continued the search that it interrupted, which is "
                + last.phase()
                + ", "
                + last.activity());
  }

  private static Optional<ResumptionFault> notResumed(String why) {
    return Optional.of(new ResumptionFault(true, why));
  }
}
