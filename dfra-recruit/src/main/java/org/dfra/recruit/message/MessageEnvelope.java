package org.dfra.recruit.message;

import java.time.Instant;
import java.util.Objects;
import org.dfra.agent.AgentMessage;

/**
 * A message with its sender, number and time.
 *
 * @param sender name of the robot that sent it
 * @param number grows with each message of that robot's agent, also across restarts of its process
 * @param time of sending, by the sender's clock, UTC; for people, never compared
 * @param message content
 */
public record MessageEnvelope(String sender, long number, Instant time, RecruitmentMessage message)
    implements AgentMessage {

  public MessageEnvelope {
    Objects.requireNonNull(sender, "sender");
    Objects.requireNonNull(time, "time");
    Objects.requireNonNull(message, "message");
  }
}
