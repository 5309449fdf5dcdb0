package org.dfra.recruit.requester;

import java.io.Serializable;
import java.time.Instant;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Refuse;

/**
 * A helper that was let go before its time, and has not yet said that it knows.
 *
 * @param conversation in which it was chosen
 * @param robot its name
 * @param again when it is told again
 * @param until when it is free by itself: it cannot come in time any more, or its lease is over
 */
record Farewell(Conversation conversation, String robot, Instant again, Instant until)
    implements Serializable {

  /** The same, told again at another time, or at its end. */
  Farewell repeatedAt(Instant then) {
    return new Farewell(conversation, robot, then.isBefore(until) ? then : until, until);
  }

  /** Whether that message proves that it is free: it says so, or has a part in a later one. */
  boolean isAcknowledgedBy(String from, RecruitmentMessage message) {
    boolean saysSo =
        message instanceof Refuse refuse
            && refuse.isFinal()
            && refuse.conversation().equals(conversation);
    return from.equals(robot) && (saysSo || message.conversation().supersedes(conversation));
  }
}
