package org.dfra.flow.motor;

import java.time.Instant;
import org.dfra.event.Reading;
import org.dfra.flow.effector.DriveCommand.Velocity;

/**
 * The velocity that a motor schema recommends.
 *
 * @param measured time of the older of the percepts it is based on, UTC
 * @param velocity the recommended velocity
 * @param reason the rule with the highest activation for it, in words
 * @param strength the activation of that rule, 0 to 1
 */
public record DriveAdvice(Instant measured, Velocity velocity, String reason, double strength)
    implements Reading {}
