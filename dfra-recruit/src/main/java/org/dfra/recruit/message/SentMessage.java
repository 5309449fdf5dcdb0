package org.dfra.recruit.message;

import java.time.Instant;
import org.dfra.event.Reading;

/**
 * Records a message that an agent sent, for observers of a conversation; the protocol does not use
 * it. A reading of the sender's module.
 *
 * @param measured time of sending, by the sender's clock, UTC
 * @param to name of the receiving robot; empty for all that can observe the percept
 * @param envelope of the message
 */
public record SentMessage(Instant measured, String to, MessageEnvelope envelope)
    implements Reading {}
