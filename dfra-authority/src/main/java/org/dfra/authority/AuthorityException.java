package org.dfra.authority;

import java.io.IOException;

/** The authority cannot do what it was asked for. The message is one sentence with the remedy. */
public final class AuthorityException extends IOException {

  private static final long serialVersionUID = 1L;

  /**
   * @param sentence the fault, its place, and the remedy
   */
  public AuthorityException(String sentence) {
    super(sentence);
  }

  public AuthorityException(String sentence, Throwable cause) {
    super(sentence, cause);
  }
}
