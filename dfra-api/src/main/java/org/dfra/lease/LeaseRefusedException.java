package org.dfra.lease;

/**
 * A lease was not granted; the message says what was asked, what is allowed and what to ask for.
 */
public class LeaseRefusedException extends Exception {

  private static final long serialVersionUID = 1L;

  public LeaseRefusedException(String message) {
    super(message);
  }
}
