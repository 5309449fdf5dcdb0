package org.dfra.recruit.responder;

import java.io.Serializable;

/**
 * A responder's record of a requester, by the numbers of its conversations; -1 for none.
 *
 * @param closed it has left this one and all earlier ones
 * @param completed the last one with an agreement
 * @param lastCall last time at which it received a call
 * @param round the last call received in that
 */
record ConversationRecord(long closed, long completed, long lastCall, int round)
    implements Serializable {

  static final ConversationRecord EMPTY = new ConversationRecord(-1, -1, -1, 0);

  ConversationRecord close(long number) {
    return new ConversationRecord(Math.max(closed, number), completed, lastCall, round);
  }

  ConversationRecord complete(long number) {
    return new ConversationRecord(closed, Math.max(completed, number), lastCall, round);
  }

  ConversationRecord recordCall(long number, int call) {
    return new ConversationRecord(closed, completed, number, call);
  }

  /** Whether that call, or a later one, was received before. */
  boolean hasReceived(long number, int call) {
    return lastCall > number || (lastCall == number && round >= call);
  }
}
