package org.dfra.river.identity;

/**
 * An identity cannot be used. The message is one sentence: which file, what is wrong, what to do.
 */
public final class IdentityException extends Exception {

  private static final long serialVersionUID = 1L;

  /**
   * @param sentence the file, the fault and the remedy
   */
  public IdentityException(String sentence) {
    super(sentence);
  }

  public IdentityException(String sentence, Throwable cause) {
    super(sentence, cause);
  }
}
