package org.dfra.recruit.responder;

import java.io.Serializable;

/**
 * A responder's record of a requester, by the numbers of its conversations; -1 for none.
 *
 * @param closed it has left this one and all earlier ones
 * @param completed the last one with an agreement
 * @param heard last time at which it received a call
 * @param round the last call received in that
 */
record Ledger(long closed, long completed, long heard, int round) implements Serializable {

  static final Ledger EMPTY = new Ledger(-1, -1, -1, 0);

  Ledger close(long number) {
    return new Ledger(Math.max(closed, number), completed, heard, round);
  }

  Ledger complete(long number) {
    return new Ledger(closed, Math.max(completed, number), heard, round);
  }

  Ledger recordCall(long number, int call) {
    return new Ledger(closed, completed, number, call);
  }

  /** Whether that call, or a later one, was received before. */
  boolean hasReceived(long number, int call) {
    return heard > number || (heard == number && round >= call);
  }
}
