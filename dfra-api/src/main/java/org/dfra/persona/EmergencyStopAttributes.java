package org.dfra.persona;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * Whether an effector is in an emergency stop.
 *
 * @param latched whether it is stopped: then it executes no commands until it is released
 * @param requester the name of the client that stopped or released it last, for operators; null if
 *     it was never stopped, or the name is lost
 * @param since when that was, by the effector's clock, UTC; null likewise
 */
public record EmergencyStopAttributes(
    boolean latched, @Nullable String requester, @Nullable Instant since) implements Attributes {}
