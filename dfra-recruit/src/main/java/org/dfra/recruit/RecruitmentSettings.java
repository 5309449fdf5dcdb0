package org.dfra.recruit;

import java.time.Duration;
import org.jspecify.annotations.Nullable;

/**
 * For how long each side of a recruitment waits. All of a team must have the same {@link
 * #replaceAfter} and {@link #margin}: that no call ever has two helpers rests on them.
 *
 * @param helpEvery a call without an offer is repeated after this
 * @param roundsPerConversation so many calls without an offer, then a new conversation begins, in
 *     which those may offer again that had given up
 * @param replaceAfter a chosen robot that is late by this is replaced
 * @param margin so much earlier than that it turns back by itself; covers what the robots' clocks
 *     differ in rate
 * @param repeatEvery an ACCEPT or ARRIVAL without an answer is repeated after this
 * @param acceptSends so many ACCEPTs without an answer, then the robot is free again
 * @param arrivalSends likewise of ARRIVAL
 * @param agreeEvery an AGREE without an ACK_ACK is repeated after this
 * @param releaseEvery the RELEASE of a helper that is let go before its time is repeated after this
 *     until it says that it knows
 * @param offerWindow for how long other offers are awaited after the first; null for as long as the
 *     requester's strategy says
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

  /** The project's own. */
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
      positive("window", offerWindow);
    }
    if (replaceAfter.compareTo(margin) <= 0) {
      throw new IllegalArgumentException(
          "replaceAfter "
              + replaceAfter.toMillis()
              + " ms <= margin "
              + margin.toMillis()
              + " ms; a robot could never come in time");
    }
    if (roundsPerConversation < 1 || acceptSends < 1 || arrivalSends < 1) {
      throw new IllegalArgumentException(
          "what is never sent is never heard; send it once at least");
    }
  }

  /**
   * For how long other offers are awaited after the first.
   *
   * @param own what the strategy says
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
