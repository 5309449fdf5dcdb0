package org.dfra.recruit.message;

import java.time.Instant;
import org.dfra.event.Reading;

/**
 * That an agent sent a letter, for those who watch a conversation; the protocol does without it. A
 * reading of the sender's module.
 *
 * @param measured when it was sent, by the sender's clock, UTC
 * @param to name of the robot that it was sent to; empty where to all that can observe the percept
 * @param envelope what was sent
 */
public record SentMessage(Instant measured, String to, MessageEnvelope envelope)
    implements Reading {}
