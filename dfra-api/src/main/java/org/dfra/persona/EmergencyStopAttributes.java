package org.dfra.persona;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * Whether an effector is stopped for an emergency.
 *
 * @param latched whether it is: then it obeys nobody until it is released
 * @param requester who stopped it, or released it last, for people; null where nobody ever did, or
 *     nobody knows any more
 * @param since when that was, by the effector's clock, UTC; null likewise
 */
public record EmergencyStopAttributes(
    boolean latched, @Nullable String requester, @Nullable Instant since) implements Attributes {}
