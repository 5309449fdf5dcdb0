package org.dfra.app.terminal;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonMappingException;
import java.io.PrintWriter;
import java.lang.reflect.Type;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dfra.text.PrintableText;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import picocli.CommandLine.Spec.Target;

/**
 * How a command answers: for people, or with {@code --json} for programs. A picocli mix-in.
 *
 * <p>What people see is made {@linkplain PrintableText printable} here: text from other computers
 * can neither control the terminal nor begin a line.
 */
public final class CommandOutput {

  @Option(names = "--json", description = "Answer in JSON.")
  private boolean json;

  @Spec(Target.MIXEE)
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private CommandSpec spec;

  /** Whether a program is asking. */
  public boolean isJson() {
    return json;
  }

  /**
   * Gives a value: as JSON, or as a table.
   *
   * @param value what the table tells, for programs
   * @param emptyMessage what people are told when there are no rows
   */
  public void table(List<?> value, Table table, String emptyMessage) {
    if (json) {
      out().println(Json.pretty(value));
    } else if (value.isEmpty()) {
      out().println(ConsoleMessages.wrapped(emptyMessage));
    } else {
      List<String> lines = table.lines(Terminal.columns());
      out().println(isColoured() ? StatusHighlighter.bold(lines.get(0)) : lines.get(0));
      lines.stream().skip(1).map(this::coloured).forEach(out()::println);
    }
    out().flush();
  }

  private boolean isColoured() {
    return spec.commandLine().getColorScheme().ansi().enabled();
  }

  private String coloured(String line) {
    return isColoured() ? StatusHighlighter.highlight(line) : line;
  }

  /** Gives a value: as JSON, or as indented lines. */
  public void details(Object value) {
    if (json) {
      out().println(Json.pretty(value));
    } else {
      shown(IndentedFormat.of(value)).forEach(out()::println);
    }
    out().flush();
  }

  /** Lines as a terminal shows them: no wider than it is, each going on below where it began. */
  private List<String> shown(List<String> lines) {
    int columns = Terminal.textColumns();
    return lines.stream()
        .map(PrintableText::line)
        .flatMap(line -> IndentedFormat.folded(line, columns).stream())
        .map(this::coloured)
        .toList();
  }

  /**
   * Gives a value: as JSON, or as a sentence.
   *
   * @param value what the sentence tells, for programs
   */
  public void sentence(Object value, String sentence) {
    out().println(json ? Json.pretty(value) : ConsoleMessages.wrapped(sentence));
    out().flush();
  }

  /**
   * Gives a value: as JSON, or as lines.
   *
   * @param value what the lines tell, for programs
   */
  public void lines(Object value, List<String> lines) {
    if (json) {
      out().println(Json.pretty(value));
    } else {
      shown(lines).forEach(out()::println);
    }
    out().flush();
  }

  /**
   * Gives lines as they are, for people.
   *
   * @param lines folded, coloured, and composed of {@linkplain PrintableText printable} texts
   */
  public void preformatted(List<String> lines) {
    lines.forEach(out()::println);
    out().flush();
  }

  /** Whether somebody still reads the answer; nobody does where it goes to a pipe that closed. */
  public boolean isOutputOpen() {
    return !out().checkError() && !System.out.checkError(); // the first hides the second's errors
  }

  /** Gives one of many values, on one line each. */
  public void line(Object value, String line) {
    out().println(json ? Json.line(value) : ConsoleMessages.wrapped(line));
    out().flush();
  }

  /**
   * What was written on the command line as a value of a type: a text, a number, a name of an
   * enumeration, a duration in seconds, an instant in ISO 8601, or anything else in JSON.
   *
   * @throws IllegalArgumentException if it is no such value
   */
  public static Object parseValue(String text, Type type) {
    if (type == String.class) {
      return text;
    }
    boolean isWord = type instanceof Class<?> c && (c.isEnum() || c == Instant.class);
    try {
      return Json.read(isWord ? '"' + (isEnum(type) ? constant(text) : text) + '"' : text, type);
    } catch (JsonProcessingException e) {
      throw new IllegalArgumentException(
          "\"" + text + "\" is no " + name(type) + "; " + howWritten(type, e), e);
    }
  }

  private static String howWritten(Type type, JsonProcessingException e) {
    if (type == Duration.class) {
      return "write seconds, such as 2.5";
    } else if (type == Instant.class) {
      return "write it in ISO 8601, such as 2026-11-21T12:00:00Z";
    } else if (type == boolean.class) {
      return "write true or false";
    } else if (type instanceof Class<?> c && c.isEnum()) {
      return "there is "
          + Arrays.stream(c.getEnumConstants())
              .map(String::valueOf)
              .collect(Collectors.joining(", "));
    } else if (type instanceof Class<?> c && c.isPrimitive()) {
      return "write a number";
    }
    String within = within(e);
    return within.isEmpty()
        ? "write it in JSON (" + e.getOriginalMessage() + ")"
        : "its \""
            + within
            + "\" cannot be read (time spans are seconds, instants ISO 8601): "
            + e.getOriginalMessage();
  }

  /**
   * Which part of a record is wrong, such as {@code place.latitude}; empty where that is unknown.
   */
  private static String within(JsonProcessingException e) {
    return e instanceof JsonMappingException mapping
        ? mapping.getPath().stream()
            .map(JsonMappingException.Reference::getFieldName)
            .filter(name -> name != null)
            .collect(Collectors.joining("."))
        : "";
  }

  private static boolean isEnum(Type type) {
    return type instanceof Class<?> c && c.isEnum();
  }

  private static String constant(String text) {
    return text.toUpperCase(Locale.ROOT);
  }

  private static String name(Type type) {
    return type instanceof Class<?> c ? c.getSimpleName() : type.getTypeName();
  }

  /** Tells people something on the side; a program is not told. */
  public void note(String sentence) {
    if (!json) {
      PrintWriter err = spec.commandLine().getErr();
      err.println(ConsoleMessages.prefixed(sentence));
      err.flush();
    }
  }

  private PrintWriter out() {
    return spec.commandLine().getOut();
  }
}
