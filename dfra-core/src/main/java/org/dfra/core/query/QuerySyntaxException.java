package org.dfra.core.query;

/**
 * A query that cannot be parsed. The message gives the position, the error, and what is expected.
 */
public final class QuerySyntaxException extends IllegalArgumentException {

  private static final long serialVersionUID = 1L;

  private final int position;

  QuerySyntaxException(Token at, String sentence) {
    super(at.positionText() + ": " + sentence);
    this.position = at.position();
  }

  /** The position of the character where parsing failed; the first is 1. */
  public int position() {
    return position;
  }
}
