package org.dfra.core.audit;

import java.time.Instant;
import java.time.temporal.ChronoUnit;

/**
 * A head that somebody keeps.
 *
 * @param received when it was received, by the keeper's clock, milliseconds
 */
record ReceivedHead(KeptHead kept, Instant received) {

  ReceivedHead {
    received = received.truncatedTo(ChronoUnit.MILLIS);
  }

  long number() {
    return kept.head().number();
  }

  boolean contradicts(KeptHead other) {
    return number() == other.head().number() && !kept.head().hash().equals(other.head().hash());
  }
}
