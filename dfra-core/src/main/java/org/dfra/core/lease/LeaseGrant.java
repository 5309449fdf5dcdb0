package org.dfra.core.lease;

import java.time.Duration;
import java.time.Instant;
import java.util.UUID;

/**
 * A granted or renewed lease.
 *
 * @param id its identity: a secret of holder and grantor
 * @param duration its duration from now
 * @param expiration when it expires, by the module's clock
 */
public record LeaseGrant(UUID id, Duration duration, Instant expiration) {}
