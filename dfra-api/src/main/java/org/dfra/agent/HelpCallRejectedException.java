package org.dfra.agent;

/**
 * A call for help was not made: nobody can observe the percept, only robots that share a name can,
 * the place is outside the field, or another call is under way; the message says which. Nothing was
 * sent.
 */
public final class HelpCallRejectedException extends IllegalArgumentException {

  private static final long serialVersionUID = 1L;

  public HelpCallRejectedException(String message) {
    super(message);
  }
}
