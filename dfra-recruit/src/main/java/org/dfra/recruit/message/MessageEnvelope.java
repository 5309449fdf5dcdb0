package org.dfra.recruit.message;

import java.time.Instant;
import java.util.Objects;
import org.dfra.agent.AgentMessage;

/**
 * A message on its way.
 *
 * @param sender name of the robot that sent it
 * @param number grows with each that robot's agent sends, also over its process' deaths
 * @param time when it was sent, by the sender's clock, UTC; for people, never compared
 * @param message what it says
 */
public record MessageEnvelope(String sender, long number, Instant time, RecruitmentMessage message)
    implements AgentMessage {

  public MessageEnvelope {
    Objects.requireNonNull(sender, "sender");
    Objects.requireNonNull(time, "time");
    Objects.requireNonNull(message, "message");
  }
}
