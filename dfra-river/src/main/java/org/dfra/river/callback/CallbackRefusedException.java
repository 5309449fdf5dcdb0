package org.dfra.river.callback;

/** An object is not called back, since its client has as many as it may. */
public final class CallbackRefusedException extends Exception {

  private static final long serialVersionUID = 1L;

  CallbackRefusedException(String message) {
    super(message);
  }
}
