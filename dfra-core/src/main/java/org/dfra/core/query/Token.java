package org.dfra.core.query;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * A token of a query.
 *
 * @param text its text, without quotation marks
 * @param position its first character in the query, from 1 on
 */
record Token(TokenType type, String text, int position) {

  enum TokenType {
    /** Letters, digits and the other characters of names and numbers. */
    WORD,
    /** A text in quotation marks. */
    TEXT,
    /** An operator or punctuation, such as {@code >=}. */
    SIGN,
    /** The end of the query. */
    END
  }

  private static final String SIGNS = "=<>≤≥!,[]°";
  private static final Set<String> DOUBLE_SIGNS = Set.of(">=", "<=", "==", "!=");

  /** Its position, as the beginning of a sentence. */
  String positionText() {
    return type == TokenType.END ? "at the end" : "at character " + position;
  }

  boolean is(String other) {
    return (type == TokenType.WORD || type == TokenType.SIGN) && text.equals(other);
  }

  /** Its text for messages. */
  String quoted() {
    return type == TokenType.END ? "the end" : '"' + text + '"';
  }

  /**
   * The tokens of a query, the last of which is its end.
   *
   * @throws QuerySyntaxException if a quotation mark is not closed
   */
  static List<Token> of(String query) {
    List<Token> tokens = new ArrayList<>();
    int at = 0;
    while (at < query.length()) {
      char c = query.charAt(at);
      int next = at + 1;
      if (c == '"') {
        StringBuilder text = new StringBuilder();
        next = quoted(query, at, text);
        tokens.add(new Token(TokenType.TEXT, text.toString(), at + 1));
      } else if (SIGNS.indexOf(c) >= 0) {
        if (next < query.length() && DOUBLE_SIGNS.contains(query.substring(at, at + 2))) {
          next++;
        }
        tokens.add(new Token(TokenType.SIGN, query.substring(at, next), at + 1));
      } else if (!Character.isWhitespace(c)) {
        while (next < query.length() && isOfAWord(query.charAt(next))) {
          next++;
        }
        tokens.add(new Token(TokenType.WORD, query.substring(at, next), at + 1));
      }
      at = next;
    }
    tokens.add(new Token(TokenType.END, "", query.length() + 1));
    return tokens;
  }

  private static boolean isOfAWord(char c) {
    return !Character.isWhitespace(c) && c != '"' && SIGNS.indexOf(c) < 0;
  }

  /** Reads a text in quotation marks; returns the position after it. */
  private static int quoted(String query, int from, StringBuilder text) {
    for (int at = from + 1; at < query.length(); at++) {
      char c = query.charAt(at);
      if (c == '"') {
        return at + 1;
      }
      if (c == '\\' && at + 1 < query.length()) {
        at++;
        c = query.charAt(at);
      }
      text.append(c);
    }
    throw new QuerySyntaxException(
        new Token(TokenType.TEXT, "", from + 1), "the quotation mark is never closed; write \"…\"");
  }
}
