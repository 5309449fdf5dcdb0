package org.dfra.recruit.river;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import net.jini.core.event.RemoteEvent;
import org.dfra.agent.AgentMessage;

/**
 * A letter as it crosses the network. Its source is the name of the robot that wrote it, its
 * sequence number the letter's: so it grows strictly with each that the robot sends, and whoever
 * gets them sees which came twice or were overtaken. It has no handback, since nobody registered.
 */
public final class AgentMessageEvent extends RemoteEvent {

  /** The one kind of event that agents send each other. */
  public static final long EVENT_ID = 1;

  private static final long serialVersionUID = 1L;

  private final AgentMessage letter;

  /** The event that carries it. */
  public AgentMessageEvent(AgentMessage letter) {
    super(letter.sender(), EVENT_ID, letter.number(), null);
    this.letter = letter;
  }

  /** What it carries. */
  public AgentMessage message() {
    return letter;
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    if (letter == null
        || getID() != EVENT_ID
        || !letter.sender().equals(getSource())
        || letter.number() != getSequenceNumber()) {
      throw new InvalidObjectException("an event that is not of the letter which it carries");
    }
  }
}
