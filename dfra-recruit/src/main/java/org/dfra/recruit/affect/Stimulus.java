package org.dfra.recruit.affect;

import java.time.Duration;
import java.time.Instant;
import org.dfra.recruit.message.Conversation;

/**
 * A received call for help.
 *
 * @param conversation of the call
 * @param eta time to reach the place
 * @param battery charge left, 0 to 1
 * @param busy whether it has work of its own
 * @param time of the call
 */
public record Stimulus(
    Conversation conversation, Duration eta, double battery, boolean busy, Instant time) {

  double etaSeconds() {
    return eta.toNanos() / 1e9;
  }
}
