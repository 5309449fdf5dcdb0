package org.dfra.core.query;

import java.lang.reflect.RecordComponent;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.dfra.core.config.NearestName;
import org.dfra.core.query.Token.TokenType;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleQuery;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;

/**
 * Parses a {@link ModuleQuery} from text. Parsing the result of {@link ModuleQuery#toString} gives
 * an equal query.
 *
 * <pre>
 *   query      = kind { [ "and" ] clause }
 *   clause     = "named" name | "on" robot | "with" test { "and" test }
 *              | "within" number ( "m" | "km" ) "of" latitude "," longitude
 *   test       = attributes "." component comparison
 *   comparison = "&gt;=" number | "&lt;=" number | "=" value | "from" number "to" number
 *              | "contains" text
 * </pre>
 *
 * <p>Each clause except {@code with} may occur once, in any order. Texts may be quoted, with {@code
 * \} to escape the next character; single words need no quotes. Degrees are WGS84, north and east
 * are +, or {@code N}, {@code S}, {@code E} or {@code W} follows.
 */
public final class QueryParser {

  private static final List<String> CLAUSES = List.of("named", "on", "with", "within");
  private static final double METRES_PER_KILOMETRE = 1000;

  private final QueryTypeNames vocabulary;

  /**
   * @param vocabulary the names that a query may use
   */
  public QueryParser(QueryTypeNames vocabulary) {
    this.vocabulary = vocabulary;
  }

  /**
   * Reads a query.
   *
   * @throws QuerySyntaxException if it is not one; the message gives the position
   */
  public ModuleQuery<? extends Module> parse(String text) {
    return new Run(Token.of(text)).query();
  }

  /** One parse. */
  private final class Run {

    private final TokenStream tokens;
    private final Set<String> seen = new HashSet<>();

    Run(List<Token> tokens) {
      this.tokens = new TokenStream(tokens);
    }

    ModuleQuery<? extends Module> query() {
      ModuleQuery<? extends Module> query =
          ModuleQuery.of(
              vocabulary.kind(tokens.expectText("a kind of module, such as GPSSensor,")));
      while (tokens.peek().type() != TokenType.END) {
        query = clause(query);
      }
      return query;
    }

    private ModuleQuery<? extends Module> clause(ModuleQuery<? extends Module> query) {
      Token first = tokens.next();
      if (first.is("and")) {
        if (seen.contains("with") && !CLAUSES.contains(tokens.peek().text())) {
          return test(query);
        }
        first = tokens.next();
      }
      if (first.type() != TokenType.WORD || !CLAUSES.contains(first.text())) {
        throw new QuerySyntaxException(
            first,
            first.quoted()
                + " begins no condition"
                + NearestName.hint(
                    first.text(), CLAUSES, "; go on with named, on, with or within"));
      }
      if (!seen.add(first.text()) && !first.is("with")) {
        throw new QuerySyntaxException(
            first, "\"" + first.text() + "\" occurs here a second time; leave one out");
      }
      return switch (first.text()) {
        case "named" -> query.name(tokens.expectText("the module's name").text());
        case "on" -> query.robot(tokens.expectText("the robot's name").text());
        case "with" -> test(query);
        default -> circle(query);
      };
    }

    private ModuleQuery<? extends Module> test(ModuleQuery<? extends Module> query) {
      Token attribute = tokens.expectText("an attribute, such as Sensor.maxRate");
      int dot = attribute.text().lastIndexOf('.');
      if (dot <= 0) {
        throw new QuerySyntaxException(
            attribute,
            attribute.quoted()
                + " is not an attribute; write one with a dot, such as Sensor.maxRate");
      }
      Class<? extends Attributes> type =
          vocabulary.attributes(attribute, attribute.text().substring(0, dot));
      RecordComponent component =
          QueryTypeNames.component(attribute, type, attribute.text().substring(dot + 1));
      Token sign = tokens.peek();
      try {
        return query.where(type, component.getName(), comparison(component));
      } catch (QuerySyntaxException e) {
        throw e;
      } catch (IllegalArgumentException e) {
        throw new QuerySyntaxException(sign, String.valueOf(e.getMessage()));
      }
    }

    private Condition comparison(RecordComponent component) {
      Token sign = tokens.next();
      return switch (sign.text()) {
        case ">=", "≥" -> Condition.atLeast(tokens.number());
        case "<=", "≤" -> Condition.atMost(tokens.number());
        case "=", "==" -> Condition.equalTo(new QueryValueParser(tokens).read(component));
        case "contains" -> Condition.contains(tokens.expectText("a text").text());
        case "from" -> {
          double least = tokens.number();
          tokens.expect("to");
          yield Condition.between(least, tokens.number());
        }
        default ->
            throw new QuerySyntaxException(
                sign,
                sign.quoted()
                    + " compares nothing; write >=, <=, =, from … to or contains after "
                    + component.getDeclaringRecord().getSimpleName()
                    + "."
                    + component.getName());
      };
    }

    private ModuleQuery<? extends Module> circle(ModuleQuery<? extends Module> query) {
      Token at = tokens.peek();
      double metres = distance();
      tokens.expect("of");
      double latitude = tokens.degrees("N", "S");
      boolean unused = tokens.accept(",");
      double longitude = tokens.degrees("E", "W");
      try {
        return query.within(metres, new GeoPosition(latitude, longitude, 0));
      } catch (IllegalArgumentException e) {
        throw new QuerySyntaxException(at, String.valueOf(e.getMessage()));
      }
    }

    /** In metres: {@code 50 m}, {@code 50m} or {@code 0.05 km}. */
    private double distance() {
      Token token = tokens.peek();
      String text = token.text();
      if (token.type() == TokenType.WORD && text.matches("[+-]?[0-9.]+k?m")) {
        boolean isKilometres = text.endsWith("km");
        Token unused = tokens.next();
        return tokens.number(
                new Token(
                    TokenType.WORD,
                    text.substring(0, text.length() - (isKilometres ? 2 : 1)),
                    token.position()))
            * (isKilometres ? METRES_PER_KILOMETRE : 1);
      }
      double number = tokens.number();
      if (tokens.accept("km")) {
        return number * METRES_PER_KILOMETRE;
      }
      tokens.expect("m");
      return number;
    }
  }
}
