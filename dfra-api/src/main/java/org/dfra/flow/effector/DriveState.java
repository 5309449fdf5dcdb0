package org.dfra.flow.effector;

import java.time.Instant;
import org.dfra.event.Reading;
import org.jspecify.annotations.Nullable;

/**
 * What a drive was told last, and what it does about it.
 *
 * @param measured the time of this, UTC
 * @param velocity what it drives by now, as it was told and limited; zero while it stands for want
 *     of commands
 * @param parkingBrakeEngaged whether the parking brake is set
 * @param commander who commands it, e.g. an address; null while nobody does
 * @param commandTimeouts how often it stood still because the next velocity came too late
 */
public record DriveState(
    Instant measured,
    DriveCommand.Velocity velocity,
    boolean parkingBrakeEngaged,
    @Nullable String commander,
    long commandTimeouts)
    implements Reading {}
