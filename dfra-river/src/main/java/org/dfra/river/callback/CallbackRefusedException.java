package org.dfra.river.callback;

/** An object is not called back because its client has reached its limit. */
public final class CallbackRefusedException extends Exception {

  private static final long serialVersionUID = 1L;

  CallbackRefusedException(String message) {
    super(message);
  }
}
