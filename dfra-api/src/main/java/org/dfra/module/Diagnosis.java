package org.dfra.module;

import java.io.Serializable;
import java.time.Duration;
import java.time.Instant;

/**
 * The result of a test or a recovery.
 *
 * @param name the test's or recovery method's name
 * @param passed whether it ended without a fault
 * @param finding what it found, a sentence
 * @param startedAt when it began
 * @param duration how long it took
 */
public record Diagnosis(
    String name, boolean passed, String finding, Instant startedAt, Duration duration)
    implements Serializable {}
