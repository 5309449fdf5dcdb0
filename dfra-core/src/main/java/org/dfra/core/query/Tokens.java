package org.dfra.core.query;

import java.util.List;
import org.dfra.core.query.Token.Sort;

/** A query's pieces, one after the other. */
final class Tokens {

  private final List<Token> tokens;
  private int next;

  Tokens(List<Token> tokens) {
    this.tokens = tokens;
  }

  Token peek() {
    return tokens.get(next);
  }

  /** The next piece; the end, ever again. */
  Token next() {
    Token token = tokens.get(next);
    if (token.sort() != Sort.END) {
      next++;
    }
    return token;
  }

  /** Takes the next piece if it is this. */
  boolean skip(String text) {
    if (peek().is(text)) {
      Token unused = next();
      return true;
    }
    return false;
  }

  /** Takes the next piece, which must be this. */
  void expect(String text) {
    Token token = next();
    if (!token.is(text)) {
      throw new QuerySyntaxException(
          token, "\"" + text + "\" must stand here, not " + token.shown());
    }
  }

  /**
   * A word or a text.
   *
   * @param what what it is, for the message where there is none
   */
  Token name(String what) {
    Token token = next();
    if (token.sort() != Sort.WORD && token.sort() != Sort.TEXT) {
      throw new QuerySyntaxException(token, what + " must stand here, not " + token.shown());
    }
    return token;
  }

  double number() {
    return number(next());
  }

  double number(Token token) {
    if (token.sort() == Sort.WORD) {
      try {
        return Double.parseDouble(token.text().replace('\u2212', '-')); // the typographic minus
      } catch (NumberFormatException e) {
        throw noNumber(token);
      }
    }
    throw noNumber(token);
  }

  private static QuerySyntaxException noNumber(Token token) {
    return new QuerySyntaxException(token, "a number must stand here, not " + token.shown());
  }

  /** An angle in degrees; the second direction turns its sign. */
  double degrees(String positive, String negative) {
    double degrees = number();
    boolean unused = skip("°");
    if (skip(negative)) {
      return -degrees;
    }
    unused = skip(positive);
    return degrees;
  }
}
