package org.dfra.recruit.message;

import java.io.Serializable;

/**
 * One attempt to find a helper. At most one robot is chosen in it; its replacement is chosen in the
 * next. Any message of a newer conversation of the same requester ends the earlier ones.
 *
 * @param requester name of the robot that needs help
 * @param number grows with each of its attempts, also across restarts of its process
 */
public record Conversation(String requester, long number) implements Serializable {

  public Conversation {
    if (requester.isBlank()) {
      throw new IllegalArgumentException("a conversation needs the name of its requester");
    }
  }

  /** The requester's next attempt. */
  public Conversation next() {
    return new Conversation(requester, number + 1);
  }

  /** Whether it ends the other one. */
  public boolean supersedes(Conversation other) {
    return requester.equals(other.requester) && number > other.number;
  }

  /** {@code uav#7}. */
  @Override
  public String toString() {
    return requester + "#" + number;
  }
}
