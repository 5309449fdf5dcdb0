package org.dfra.river.call;

import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.RemoteException;

/** The state of an object's activation is unknown because the activator did not answer. */
final class ActivatorUnreachableException extends Exception {

  private static final long serialVersionUID = 1L;

  ActivatorUnreachableException(RemoteException cause) {
    super(cause);
  }

  /**
   * Converts it to the failure of a call that has not run.
   *
   * @param attempt the failure of the call to the object itself
   */
  RemoteException forCaller(RemoteException attempt) {
    RemoteException reported = forCaller();
    reported.addSuppressed(attempt);
    return reported;
  }

  /** Converts it to the failure of a call that has not run. */
  RemoteException forCaller() {
    Exception cause = (Exception) getCause();
    return cause instanceof ConnectException
        ? new ConnectException("the activation system cannot be reached", cause)
        : new ConnectIOException("the activation system did not answer", cause);
  }
}
