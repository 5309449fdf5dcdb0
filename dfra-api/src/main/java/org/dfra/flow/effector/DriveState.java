package org.dfra.flow.effector;

import java.time.Instant;
import org.dfra.event.Reading;
import org.jspecify.annotations.Nullable;

/**
 * The last command to a drive, and its state.
 *
 * @param measured the time of this, UTC
 * @param velocity the current commanded velocity, after limiting; zero after a command timeout
 * @param parkingBrakeEngaged whether the parking brake is set
 * @param commander its commander, e.g. an address; null if there is none
 * @param commandTimeouts how often it stopped because the next velocity came too late
 */
public record DriveState(
    Instant measured,
    DriveCommand.Velocity velocity,
    boolean parkingBrakeEngaged,
    @Nullable String commander,
    long commandTimeouts)
    implements Reading {}
