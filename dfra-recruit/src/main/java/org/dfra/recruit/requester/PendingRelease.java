package org.dfra.recruit.requester;

import java.io.Serializable;
import java.time.Instant;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Refuse;

/**
 * A helper released before its lease's end that has not acknowledged it yet.
 *
 * @param conversation of its choice
 * @param robot its name
 * @param again time of the next repetition
 * @param until time from which it is free without an acknowledgement: it cannot arrive in time any
 *     more, or its lease has ended
 */
record PendingRelease(Conversation conversation, String robot, Instant again, Instant until)
    implements Serializable {

  /** The same, with another time of repetition, at most its end. */
  PendingRelease repeatedAt(Instant then) {
    return new PendingRelease(conversation, robot, then.isBefore(until) ? then : until, until);
  }

  /**
   * Whether that message proves that it is free: an acknowledgement, or a message of a later
   * conversation.
   */
  boolean isAcknowledgedBy(String from, RecruitmentMessage message) {
    boolean saysSo =
        message instanceof Refuse refuse
            && refuse.isFinal()
            && refuse.conversation().equals(conversation);
    return from.equals(robot) && (saysSo || message.conversation().supersedes(conversation));
  }
}
