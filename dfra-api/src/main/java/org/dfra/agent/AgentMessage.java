package org.dfra.agent;

import java.io.Serializable;

/** What one agent tells another. Immutable. It may come late, twice, or never. */
public interface AgentMessage extends Serializable {

  /** Name of the robot that sent it. */
  String sender();

  /**
   * Grows with each message that this robot sends, whomever to, also over its process' deaths. A
   * smaller one that comes after a greater one was overtaken; the same one is a duplicate. Where
   * numbers are missing, they were for others or are lost.
   */
  long number();
}
