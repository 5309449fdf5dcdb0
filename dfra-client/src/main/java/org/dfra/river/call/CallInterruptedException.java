package org.dfra.river.call;

import java.rmi.RemoteException;

/** The caller's thread was interrupted while it waited for the response to a remote call. */
public final class CallInterruptedException extends RemoteException {

  private static final long serialVersionUID = 1L;

  CallInterruptedException(String call, boolean mayHaveRun) {
    super(
        call
            + " was interrupted while it waited for its answer; "
            + (mayHaveRun ? "it may have run" : "it has not run"));
  }
}
