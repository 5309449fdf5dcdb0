package org.dfra.recruit.message;

import java.io.Serializable;

/**
 * One attempt to find a helper. A robot is chosen once in it at the most; whoever is to be replaced
 * is replaced in the next. That the requester has begun the next one, in whichever message somebody
 * hears it, ends the ones before.
 *
 * @param requester name of the robot that needs help
 * @param number grows with each of its attempts, also over its process' deaths
 */
public record Conversation(String requester, long number) implements Serializable {

  public Conversation {
    if (requester.isBlank()) {
      throw new IllegalArgumentException("a conversation that nobody began");
    }
  }

  /** The requester's next attempt. */
  public Conversation next() {
    return new Conversation(requester, number + 1);
  }

  /** Whether it makes that one a thing of the past. */
  public boolean supersedes(Conversation other) {
    return requester.equals(other.requester) && number > other.number;
  }

  /** {@code uav#7}. */
  @Override
  public String toString() {
    return requester + "#" + number;
  }
}
