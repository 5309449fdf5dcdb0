package org.dfra.recruit.responder;

import java.io.Serializable;

/**
 * What a responder remembers of a requester, by the numbers of its conversations; -1 for none.
 *
 * @param closed it has no part any more in this one and those before
 * @param completed the last in which it was agreed with
 * @param heard the last in which it heard a call
 * @param round the last call that it heard in that
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

  /** Whether that call was heard before, or one after it. */
  boolean hasReceived(long number, int call) {
    return heard > number || (heard == number && round >= call);
  }
}
