package org.dfra.recruit.transport;

import java.util.List;
import org.dfra.recruit.message.MessageEnvelope;

/**
 * Sends messages to other agents. A message may be lost without notice, late, duplicated or
 * reordered. Its methods do not block and do not call the agent back before they return.
 */
public interface Transport {

  /**
   * Names of the other robots whose agents declare the percept, as far as is known. A name of
   * several robots is omitted: see {@link #ambiguousNames}.
   */
  List<String> capableRobots(String percept);

  /**
   * The reasons why nothing is sent to some robots that declare the percept: each name of several
   * robots, in a clause with their hosts. Empty where all names are unique.
   */
  default List<String> ambiguousNames(String percept) {
    return List.of();
  }

  /** Every percept that another robot declares, in alphabetical order. */
  List<String> percepts();

  /**
   * Sends to one robot. The message is lost where several robots have that name, so no other robot
   * gets it.
   */
  void send(String robot, MessageEnvelope envelope);

  /**
   * Sends to all robots that can observe the percept, with one transmission where the network
   * supports it.
   */
  void broadcast(String percept, MessageEnvelope envelope);
}
