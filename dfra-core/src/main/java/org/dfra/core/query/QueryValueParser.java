package org.dfra.core.query;

import java.lang.reflect.RecordComponent;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.core.config.NearestName;
import org.dfra.core.query.Token.TokenType;

/** Parses the value that a component must equal, by the component's type. */
final class QueryValueParser {

  private final TokenStream tokens;

  QueryValueParser(TokenStream tokens) {
    this.tokens = tokens;
  }

  Object read(RecordComponent component) {
    Class<?> type = component.getType();
    if (type == List.class) {
      return list();
    } else if (type == String.class) {
      return tokens.expectText("a text").text();
    } else if (type == boolean.class || type == Boolean.class) {
      return truth();
    } else if (type.isEnum()) {
      return constant(type);
    } else if (type == Instant.class) {
      return instant();
    }
    return number();
  }

  private List<String> list() {
    if (!tokens.accept("[")) {
      Token token = tokens.peek();
      throw new QuerySyntaxException(
          token, "a list is expected here, such as [\"2D\", \"3D\"], not " + token.quoted());
    }
    List<String> texts = new ArrayList<>();
    if (tokens.accept("]")) {
      return texts;
    }
    do {
      texts.add(tokens.expectText("a text").text());
    } while (tokens.accept(","));
    tokens.expect("]");
    return texts;
  }

  private boolean truth() {
    Token token = tokens.next();
    if (!token.is("true") && !token.is("false")) {
      throw new QuerySyntaxException(
          token, "true or false is expected here, not " + token.quoted());
    }
    return token.is("true");
  }

  private Object constant(Class<?> type) {
    Token token = tokens.expectText("a " + type.getSimpleName());
    List<String> names = new ArrayList<>();
    for (Object each : type.getEnumConstants()) {
      String name = ((Enum<?>) each).name();
      if (name.equals(token.text().toUpperCase(Locale.ROOT))) {
        return each;
      }
      names.add(name);
    }
    throw new QuerySyntaxException(
        token,
        token.quoted()
            + " is not a value of "
            + type.getSimpleName()
            + NearestName.hint(
                token.text().toUpperCase(Locale.ROOT),
                names,
                "; there is " + String.join(", ", names)));
  }

  private Instant instant() {
    Token token = tokens.expectText("an instant");
    try {
      return Instant.parse(token.text());
    } catch (DateTimeParseException e) {
      throw new QuerySyntaxException(
          token, token.quoted() + " is not an instant in UTC; write it like 2026-11-21T12:00:00Z");
    }
  }

  /** A whole number if it is one, since a double cannot represent every long. */
  private Number number() {
    Token token = tokens.next();
    if (token.type() == TokenType.WORD) {
      try {
        return Long.valueOf(token.text());
      } catch (NumberFormatException e) { // it has a fraction, or is not a number
        return tokens.number(token);
      }
    }
    return tokens.number(token);
  }
}
