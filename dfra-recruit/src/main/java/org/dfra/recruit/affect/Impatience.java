package org.dfra.recruit.affect;

import java.time.Duration;
import java.time.Instant;
import org.dfra.core.config.ConfigurationException;
import org.dfra.recruit.message.Conversation;
import org.jspecify.annotations.Nullable;

/**
 * Motivation as in ALLIANCE: it grows with the time for which a call stays unanswered, at a rate
 * that is slower the farther and the busier the robot is, and falls to 0 when a robot takes the
 * task. Source of the idea: L. E. Parker, "ALLIANCE: an architecture for fault tolerant multirobot
 * cooperation", IEEE Transactions on Robotics and Automation 14 (1998). Robots do not pre-empt each
 * other here.
 *
 * <p>The first call received in a conversation counts as unanswered for the default call interval,
 * and each further one for the time since the previous call. The time between two conversations
 * does not count: another robot may have helped meanwhile, and its message may have been lost.
 */
public final class Impatience implements Affect {

  private final double fastest;
  private final double slowest;
  private final double etaReference;
  private final Duration first;
  private double level;
  private @Nullable Conversation last;
  private Instant received = Instant.MIN;

  /**
   * @param minWaitSeconds seconds until an idle robot at the place reaches the threshold, above 0
   * @param maxWaitSeconds seconds until one at {@code etaReference} or beyond does, not less
   * @param etaReference seconds, above 0
   * @param callInterval waiting time for which the first call of a conversation counts
   */
  public Impatience(
      double minWaitSeconds, double maxWaitSeconds, double etaReference, Duration callInterval) {
    if (!(minWaitSeconds > 0 && maxWaitSeconds >= minWaitSeconds && etaReference > 0)) {
      throw new ConfigurationException(
          "impatience needs a shortest wait above 0 s, a longest wait that is not shorter, and a"
              + " reference ETA above 0 s, not "
              + minWaitSeconds
              + " s, "
              + maxWaitSeconds
              + " s and "
              + etaReference
              + " s");
    }
    this.fastest = minWaitSeconds;
    this.slowest = maxWaitSeconds;
    this.etaReference = etaReference;
    this.first = callInterval;
  }

  @Override
  public double level() {
    return level;
  }

  @Override
  public void stimulate(Stimulus stimulus) {
    boolean isFirst = !stimulus.conversation().equals(last);
    Duration waited = isFirst ? first : Duration.between(received, stimulus.time());
    double share = Math.min(1, stimulus.etaSeconds() / etaReference);
    double until = (fastest + (slowest - fastest) * share) * (stimulus.busy() ? 2 : 1);
    level = Math.min(1, level + Math.max(0, waited.toNanos() / 1e9) / until);
    last = stimulus.conversation();
    received = stimulus.time();
  }

  @Override
  public void onHelping() {
    reset();
  }

  @Override
  public void onRelease() {
    reset();
  }

  private void reset() {
    level = 0;
    last = null;
  }

  @Override
  public void restore(double kept) {
    level = kept;
  }
}
