package org.dfra.river.security.robot;

import java.io.IOException;
import java.rmi.Remote;
import java.util.List;
import org.dfra.module.Administrative;
import org.dfra.module.Idempotent;

/**
 * What operators say to a robot about decisions by its policy. Each process of a robot with modules
 * exports it, and answers for all processes of the robot on its computer.
 */
public interface PolicyControl extends Remote {

  /**
   * What the robot knows about itself.
   *
   * @throws IOException if it cannot be read
   */
  @Idempotent
  KnownFacts facts() throws IOException;

  /**
   * Sets a named fact. It stays set until it is changed, also after a restart. All processes of the
   * robot know it within half a second.
   *
   * @param value the value; empty if the fact is to be unknown from now on
   * @throws IllegalArgumentException if no fact can have this name or value, or there are too many
   * @throws IOException if it cannot be stored
   */
  @Administrative
  @Idempotent
  void setFact(String name, String value) throws IOException;

  /**
   * The calls that wait for a confirmation, the oldest first.
   *
   * @throws IOException if they cannot be read
   */
  @Idempotent
  List<WaitingRequest> requests() throws IOException;

  /**
   * Answers a request. If it is confirmed, the next such call of its caller is permitted, once,
   * within 300 s. Otherwise such calls are refused for 300 s.
   *
   * @return false if no such request waits any more
   * @throws IOException if the answer cannot be stored
   */
  @Administrative
  boolean answer(String id, boolean isConfirmed) throws IOException;
}
