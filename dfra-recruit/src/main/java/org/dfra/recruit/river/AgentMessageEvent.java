package org.dfra.recruit.river;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import net.jini.core.event.RemoteEvent;
import org.dfra.agent.AgentMessage;

/**
 * A message as a remote event. Its source is the name of the sending robot, its sequence number the
 * message's: it is strictly increasing per sender, so a receiver detects duplicates and reordering.
 * It has no handback, since there is no registration.
 */
public final class AgentMessageEvent extends RemoteEvent {

  /** The event ID of all messages between agents. */
  public static final long EVENT_ID = 1;

  private static final long serialVersionUID = 1L;

  private final AgentMessage envelope;

  /** Creates the event of a message. */
  public AgentMessageEvent(AgentMessage envelope) {
    super(envelope.sender(), EVENT_ID, envelope.number(), null);
    this.envelope = envelope;
  }

  /** The message. */
  public AgentMessage message() {
    return envelope;
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    if (envelope == null
        || getID() != EVENT_ID
        || !envelope.sender().equals(getSource())
        || envelope.number() != getSequenceNumber()) {
      throw new InvalidObjectException(
          "the event's source or number differs from that of its message");
    }
  }
}
