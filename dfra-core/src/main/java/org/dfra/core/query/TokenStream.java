package org.dfra.core.query;

import java.util.List;
import org.dfra.core.query.Token.TokenType;

/** The stream of a query's tokens. */
final class TokenStream {

  private final List<Token> tokens;
  private int next;

  TokenStream(List<Token> tokens) {
    this.tokens = tokens;
  }

  Token peek() {
    return tokens.get(next);
  }

  /** The next token; at the end, the end token again. */
  Token next() {
    Token token = tokens.get(next);
    if (token.type() != TokenType.END) {
      next++;
    }
    return token;
  }

  /** Consumes the next token if it is this text. */
  boolean accept(String text) {
    if (peek().is(text)) {
      Token unused = next();
      return true;
    }
    return false;
  }

  /** Consumes the next token, which must be this text. */
  void expect(String text) {
    Token token = next();
    if (!token.is(text)) {
      throw new QuerySyntaxException(
          token, "\"" + text + "\" is expected here, not " + token.quoted());
    }
  }

  /**
   * A word or a text.
   *
   * @param what what is expected, for the error message
   */
  Token expectText(String what) {
    Token token = next();
    if (token.type() != TokenType.WORD && token.type() != TokenType.TEXT) {
      throw new QuerySyntaxException(token, what + " is expected here, not " + token.quoted());
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
    return new QuerySyntaxException(token, "a number is expected here, not " + token.quoted());
  }

  /** An angle in degrees; the second direction negates it. */
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
