package org.dfra.recruit.transport;

import java.util.List;
import org.dfra.recruit.message.MessageEnvelope;

/**
 * The way to other agents. A letter may be lost, and nobody is told; it may come late, twice, or
 * after one that was sent later. Its methods do not block and do not call the agent back before
 * they return.
 */
public interface Transport {

  /**
   * Names of the other robots whose agents say that they can observe it, as far as is known. A name
   * that several robots have is left out: see {@link #ambiguousNames}.
   */
  List<String> capableRobots(String percept);

  /**
   * Why nothing is sent to robots that say that they can observe it: each name that several robots
   * have, in a clause with their hosts. Empty where every robot has a name of its own.
   */
  default List<String> ambiguousNames(String percept) {
    return List.of();
  }

  /** Every percept that another robot says it can observe, in alphabetical order. */
  List<String> percepts();

  /** To one robot. It is lost where several robots have that name, so no other robot gets it. */
  void send(String robot, MessageEnvelope letter);

  /** To all that can observe it, with one transmission where the network can do that. */
  void broadcast(String percept, MessageEnvelope letter);
}
