package org.dfra.agent;

/**
 * A call for help was rejected: no robot can observe the percept, only robots that share a name
 * can, the place is outside the field, or another call is in progress. The message gives the
 * reason. Nothing was sent.
 */
public final class HelpCallRejectedException extends IllegalArgumentException {

  private static final long serialVersionUID = 1L;

  public HelpCallRejectedException(String message) {
    super(message);
  }
}
