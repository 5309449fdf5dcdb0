package org.dfra.core.lease;

import java.time.Duration;
import java.time.Instant;
import java.util.UUID;

/**
 * A lease as it was granted or renewed.
 *
 * @param id what its holder names it by: a secret of holder and grantor
 * @param duration for how long from now
 * @param expiration when that is over, by the module's clock
 */
public record LeaseGrant(UUID id, Duration duration, Instant expiration) {}
