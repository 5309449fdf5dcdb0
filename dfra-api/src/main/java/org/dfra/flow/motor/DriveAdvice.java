package org.dfra.flow.motor;

import java.time.Instant;
import org.dfra.event.Reading;
import org.dfra.flow.effector.DriveCommand.Velocity;

/**
 * What a motor schema would have the wheels do.
 *
 * @param measured time of the older of the percepts it rests on, UTC
 * @param velocity what it would have them do
 * @param reason the rule that speaks loudest for it, in words
 * @param strength how much that rule applies, 0 to 1
 */
public record DriveAdvice(Instant measured, Velocity velocity, String reason, double strength)
    implements Reading {}
