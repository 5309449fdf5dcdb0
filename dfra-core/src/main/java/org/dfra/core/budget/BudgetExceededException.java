package org.dfra.core.budget;

/** A listener is refused, since its caller or module has as many as a budget allows. */
public final class BudgetExceededException extends Exception {

  private static final long serialVersionUID = 1L;

  BudgetExceededException(String message) {
    super(message);
  }
}
