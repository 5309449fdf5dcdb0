package org.dfra.river.call;

import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.RemoteException;

/** Nothing is known of an object's activation, since the activator did not answer. */
final class ActivatorUnreachableException extends Exception {

  private static final long serialVersionUID = 1L;

  ActivatorUnreachableException(RemoteException cause) {
    super(cause);
  }

  /**
   * The same in the terms of a call, which has not run.
   *
   * @param attempt how the object itself could not be reached
   */
  RemoteException forCaller(RemoteException attempt) {
    RemoteException reported = forCaller();
    reported.addSuppressed(attempt);
    return reported;
  }

  /** The same in the terms of a call, which has not run. */
  RemoteException forCaller() {
    Exception cause = (Exception) getCause();
    return cause instanceof ConnectException
        ? new ConnectException("the activation system cannot be reached", cause)
        : new ConnectIOException("the activation system did not answer", cause);
  }
}
