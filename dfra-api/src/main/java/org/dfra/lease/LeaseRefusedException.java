package org.dfra.lease;

/**
 * A lease was refused. The message names the request, what is allowed, and what to request instead.
 */
public class LeaseRefusedException extends Exception {

  private static final long serialVersionUID = 1L;

  public LeaseRefusedException(String message) {
    super(message);
  }
}
