package org.dfra.agent;

import java.io.Serializable;

/** A message that one agent sends to another. Immutable. It may arrive late, twice, or never. */
public interface AgentMessage extends Serializable {

  /** Name of the robot that sent it. */
  String sender();

  /**
   * The sender's sequence number. It grows with each message that this robot sends to any receiver,
   * also across restarts of its process. A smaller number after a greater one means that the
   * message was overtaken; an equal number means a duplicate. Missing numbers belong to messages to
   * other receivers or to lost messages.
   */
  long number();
}
