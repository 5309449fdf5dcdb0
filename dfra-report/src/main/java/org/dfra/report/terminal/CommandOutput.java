package org.dfra.report.terminal;

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
 * The output of a command: text, or with {@code --json} JSON. A picocli mix-in.
 *
 * <p>This class makes text output {@linkplain PrintableText printable}: text from other computers
 * can neither control the terminal nor start a line.
 */
public final class CommandOutput {

  @Option(names = "--json", description = "Answer in JSON.")
  private boolean json;

  @Spec(Target.MIXEE)
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** Whether the output is JSON. */
  public boolean isJson() {
    return json;
  }

  /**
   * Prints a value: as JSON, or as a table.
   *
   * @param value the table's content, for JSON
   * @param emptyMessage the text if there are no rows
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

  /** Prints a value: as JSON, or as indented lines. */
  public void details(Object value) {
    if (json) {
      out().println(Json.pretty(value));
    } else {
      shown(IndentedFormat.of(value)).forEach(out()::println);
    }
    out().flush();
  }

  /** Lines wrapped to the width of the terminal, with hanging indents. */
  private List<String> shown(List<String> lines) {
    int columns = Terminal.textColumns();
    return lines.stream()
        .map(PrintableText::line)
        .flatMap(line -> IndentedFormat.folded(line, columns).stream())
        .map(this::coloured)
        .toList();
  }

  /**
   * Prints a value: as JSON, or as a sentence.
   *
   * @param value the sentence's content, for JSON
   */
  public void sentence(Object value, String sentence) {
    out().println(json ? Json.pretty(value) : ConsoleMessages.wrapped(sentence));
    out().flush();
  }

  /**
   * Prints a value: as JSON, or as lines.
   *
   * @param value the lines' content, for JSON
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
   * Prints unchanged lines as text.
   *
   * @param lines wrapped, coloured, and composed of {@linkplain PrintableText printable} texts
   */
  public void preformatted(List<String> lines) {
    lines.forEach(out()::println);
    out().flush();
  }

  /** Whether the output is still open; it is not if it is a pipe whose reader has closed. */
  public boolean isOutputOpen() {
    return !out().checkError() && !System.out.checkError(); // the first hides the second's errors
  }

  /** Prints one of many values, on one line each. */
  public void line(Object value, String line) {
    out().println(json ? Json.line(value) : ConsoleMessages.wrapped(line));
    out().flush();
  }

  /**
   * Parses a command-line argument as a value of a type: a text, a number, a name of an
   * enumeration, a duration in seconds, an instant in ISO 8601, or any other type as JSON.
   *
   * @throws IllegalArgumentException if it is not such a value
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

  /** The path of the invalid part of a record, such as {@code place.latitude}; empty if unknown. */
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

  /** Prints a note on standard error; with JSON output it prints nothing. */
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
