package org.dfra.core.query;

/** A query that cannot be read; the message says where, what is wrong, and what would be right. */
public final class QuerySyntaxException extends IllegalArgumentException {

  private static final long serialVersionUID = 1L;

  private final int position;

  QuerySyntaxException(Token at, String sentence) {
    super(at.positionText() + ": " + sentence);
    this.position = at.position();
  }

  /** The character of the query where it cannot be read any further; the first is 1. */
  public int position() {
    return position;
  }
}
