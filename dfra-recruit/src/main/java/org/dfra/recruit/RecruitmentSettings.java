package org.dfra.recruit;

import java.time.Duration;
import org.jspecify.annotations.Nullable;

/**
 * Timeouts of both sides of a recruitment. All robots of a team must have the same {@link
 * #replaceAfter} and {@link #margin}: these ensure that no call ever has two helpers.
 *
 * @param helpEvery a call without an offer is repeated after this
 * @param roundsPerConversation number of calls without an offer before a new conversation begins,
 *     in which robots that had given up may offer again
 * @param replaceAfter a chosen robot that is later than this is replaced
 * @param margin the chosen robot withdraws this much earlier; covers different clock rates
 * @param repeatEvery an ACCEPT or ARRIVAL without an answer is repeated after this
 * @param acceptSends number of ACCEPTs without an answer after which the robot is free again
 * @param arrivalSends likewise of ARRIVAL
 * @param agreeEvery an AGREE without an ACK_ACK is repeated after this
 * @param releaseEvery the RELEASE of a helper before its lease's end is repeated after this until
 *     it is acknowledged
 * @param offerWindow wait for other offers after the first; null for the strategy's own
 */
public record RecruitmentSettings(
    Duration helpEvery,
    int roundsPerConversation,
    Duration replaceAfter,
    Duration margin,
    Duration repeatEvery,
    int acceptSends,
    int arrivalSends,
    Duration agreeEvery,
    Duration releaseEvery,
    @Nullable Duration offerWindow) {

  /** DFRA's defaults. */
  public static final RecruitmentSettings DEFAULT =
      new RecruitmentSettings(
          Duration.ofSeconds(5),
          6,
          Duration.ofSeconds(20),
          Duration.ofSeconds(1),
          Duration.ofSeconds(6),
          4,
          4,
          Duration.ofSeconds(2),
          Duration.ofMillis(500),
          null);

  public RecruitmentSettings {
    positive("helpEvery", helpEvery);
    positive("repeatEvery", repeatEvery);
    positive("agreeEvery", agreeEvery);
    positive("releaseEvery", releaseEvery);
    positive("margin", margin);
    if (offerWindow != null) {
      positive("offer_window", offerWindow);
    }
    if (replaceAfter.compareTo(margin) <= 0) {
      throw new IllegalArgumentException(
          "no robot could arrive in time, since replace_after, "
              + replaceAfter.toMillis()
              + " ms, is not above margin, "
              + margin.toMillis()
              + " ms; choose a longer replace_after");
    }
    if (roundsPerConversation < 1 || acceptSends < 1 || arrivalSends < 1) {
      throw new IllegalArgumentException(
          "calls, ACCEPTs and ARRIVALs must each be sent once or more, not "
              + roundsPerConversation
              + ", "
              + acceptSends
              + " and "
              + arrivalSends
              + " times");
    }
  }

  /**
   * The wait for other offers after the first.
   *
   * @param own the strategy's own window
   */
  public Duration offerWindowOr(Duration own) {
    return offerWindow == null ? own : offerWindow;
  }

  private static void positive(String what, Duration duration) {
    if (duration.isNegative() || duration.isZero()) {
      throw new IllegalArgumentException(what + " " + duration.toMillis() + " ms is not above 0");
    }
  }
}
