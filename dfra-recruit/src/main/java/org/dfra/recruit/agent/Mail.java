package org.dfra.recruit.agent;

import org.dfra.recruit.message.Letter;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.transport.MessageMode;

/** What an agent sends: it numbers and dates each message. Everything happens in its turns. */
final class Mail {

  private final String robot;
  private final MessageMode mode;
  private final RecruiterPorts ports;
  private final RecruiterListener listener;
  private long letters;

  Mail(String robot, MessageMode mode, RecruiterPorts ports, RecruiterListener listener) {
    this.robot = robot;
    this.mode = mode;
    this.ports = ports;
    this.listener = listener;
    this.letters = ports.steady().millis(); // more than it sent in earlier lives: one a millisecond
  }

  void toOne(String to, RecruitmentMessage message) {
    Letter letter = letter(message);
    listener.sent(to, letter);
    ports.transport().send(to, letter);
  }

  /** To all that can observe that. */
  void toTeam(String percept, RecruitmentMessage message) {
    Letter letter = letter(message);
    listener.sent("", letter);
    if (mode == MessageMode.BROADCAST) {
      ports.transport().broadcast(percept, letter);
    } else {
      ports.transport().capable(percept).forEach(each -> ports.transport().send(each, letter));
    }
  }

  private Letter letter(RecruitmentMessage message) {
    return new Letter(robot, ++letters, ports.clock().instant(), message);
  }
}
