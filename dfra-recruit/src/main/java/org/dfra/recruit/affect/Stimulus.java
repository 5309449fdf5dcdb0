package org.dfra.recruit.affect;

import java.time.Duration;
import java.time.Instant;
import org.dfra.recruit.message.Conversation;

/**
 * That a robot was asked.
 *
 * @param conversation in which
 * @param eta how long it would take to be there
 * @param battery charge left, 0 to 1
 * @param busy whether it has work of its own
 * @param time when it was asked
 */
public record Stimulus(
    Conversation conversation, Duration eta, double battery, boolean busy, Instant time) {

  double etaSeconds() {
    return eta.toNanos() / 1e9;
  }
}
