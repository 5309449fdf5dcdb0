package org.dfra.behavior.earlier;

import java.io.Serializable;
import java.time.Instant;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;

/** As it crossed the network before parts were counted. */
public record BehaviorStatus(
    Instant measured, UUID goal, Phase phase, String doing, double done, int missed)
    implements Serializable {}
