package org.dfra.river.call;

import java.rmi.RemoteException;

/** What a call ends with that got no answer in time, for tests that play the one called. */
public final class MissedDeadline {

  private MissedDeadline() {}

  /**
   * As the call layer throws it.
   *
   * @param call what was called
   */
  public static RemoteException of(String call) {
    return new DeadlineExceededException(call + " got no answer within 2000 ms");
  }
}
