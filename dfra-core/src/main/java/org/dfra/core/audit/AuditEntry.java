package org.dfra.core.audit;

import java.time.Instant;
import java.util.Optional;

/**
 * A record before it has its place in the chain.
 *
 * @param time when the event happened; of a sum, when the interval ended
 * @param count how many equal events it stands for
 * @param since of a sum, when the interval began
 */
record AuditEntry(AuditEvent event, Instant time, long count, Optional<Instant> since) {

  static AuditEntry single(AuditEvent event, Instant time) {
    return new AuditEntry(event, time, 1, Optional.empty());
  }
}
