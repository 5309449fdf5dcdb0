package org.dfra.recruit.agent;

import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.transport.Transport.MessageMode;

/**
 * Sends an agent's messages, with a number and a timestamp each. It runs only inside the agent's
 * event queue.
 */
final class MessageSender {

  private final String robot;
  private final MessageMode mode;
  private final RecruiterPorts ports;
  private final RecruiterListener listener;
  private long envelopes;

  MessageSender(String robot, MessageMode mode, RecruiterPorts ports, RecruiterListener listener) {
    this.robot = robot;
    this.mode = mode;
    this.ports = ports;
    this.listener = listener;
    this.envelopes =
        ports.monotonicClock().millis(); // above earlier processes' numbers: one a millisecond
  }

  void send(String to, RecruitmentMessage message) {
    MessageEnvelope envelope = envelope(message);
    listener.sent(to, envelope);
    ports.transport().send(to, envelope);
  }

  /** Sends to all robots that can observe the percept. */
  void sendToTeam(String percept, RecruitmentMessage message) {
    MessageEnvelope envelope = envelope(message);
    listener.sent("", envelope);
    if (mode == MessageMode.BROADCAST) {
      ports.transport().broadcast(percept, envelope);
    } else {
      ports
          .transport()
          .capableRobots(percept)
          .forEach(each -> ports.transport().send(each, envelope));
    }
  }

  private MessageEnvelope envelope(RecruitmentMessage message) {
    return new MessageEnvelope(robot, ++envelopes, ports.clock().instant(), message);
  }
}
