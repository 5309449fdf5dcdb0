package org.dfra.core.query;

import java.util.List;
import org.dfra.core.query.Token.TokenType;

/** A query's pieces, one after the other. */
final class TokenStream {

  private final List<Token> tokens;
  private int next;

  TokenStream(List<Token> tokens) {
    this.tokens = tokens;
  }

  Token peek() {
    return tokens.get(next);
  }

  /** The next piece; the end, ever again. */
  Token next() {
    Token token = tokens.get(next);
    if (token.type() != TokenType.END) {
      next++;
    }
    return token;
  }

  /** Takes the next piece if it is this. */
  boolean accept(String text) {
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
          token, "\"" + text + "\" must stand here, not " + token.quoted());
    }
  }

  /**
   * A word or a text.
   *
   * @param what what it is, for the message where there is none
   */
  Token expectText(String what) {
    Token token = next();
    if (token.type() != TokenType.WORD && token.type() != TokenType.TEXT) {
      throw new QuerySyntaxException(token, what + " must stand here, not " + token.quoted());
    }
    return token;
  }

  double number() {
    return number(next());
  }

  double number(Token token) {
    if (token.type() == TokenType.WORD) {
      try {
        return Double.parseDouble(token.text().replace('\u2212', '-')); // the typographic minus
      } catch (NumberFormatException e) {
        throw noNumber(token);
      }
    }
    throw noNumber(token);
  }

  private static QuerySyntaxException noNumber(Token token) {
    return new QuerySyntaxException(token, "a number must stand here, not " + token.quoted());
  }

  /** An angle in degrees; the second direction turns its sign. */
  double degrees(String positive, String negative) {
    double degrees = number();
    boolean unused = accept("°");
    if (accept(negative)) {
      return -degrees;
    }
    unused = accept(positive);
    return degrees;
  }
}
