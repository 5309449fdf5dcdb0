package org.dfra.behavior.earlier;

import java.io.Serializable;
import java.time.Instant;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;

/** Before parts were counted, by the names that its components have since. */
public record BehaviorStatus(
    Instant measured, UUID goal, Phase phase, String activity, double completion, int skippedParts)
    implements Serializable {}
