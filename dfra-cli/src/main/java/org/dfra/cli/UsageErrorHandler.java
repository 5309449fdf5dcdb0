package org.dfra.cli;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dfra.cli.completion.ScriptVerbs;
import org.dfra.core.config.NearestName;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.ConsoleMessages;
import picocli.CommandLine;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Reports a usage error in one sentence, and where to read about the correct usage. */
final class UsageErrorHandler implements IParameterExceptionHandler {

  private static final Pattern VALUE =
      Pattern.compile(
          "Invalid value for (?:option '(?<option>[^']+)'(?: \\([^)]*\\))?"
              + "|positional parameter at index \\S+ \\((?<label>[^)]*)\\)): "
              + "(?:'(?<number>.*)' is not an? (?<type>int|long|double)"
              + "|expected one of \\[(?<choices>.*)] \\(case-insensitive\\)"
              + " but was '(?<written>.*)')");

  @Override
  public int handleParseException(ParameterException e, String[] args) {
    CommandLine line = e.getCommandLine();
    boolean isNothingAsked = line.getParent() == null && args.length == 0;
    if (isNothingAsked) {
      line.usage(line.getErr());
    } else {
      line.getErr().println(ConsoleMessages.prefixed(sentence(e, line)));
    }
    return line.getCommandSpec().exitCodeOnInvalidInput();
  }

  private static String sentence(ParameterException e, CommandLine line) {
    String asked = line.getCommandSpec().qualifiedName(" ").replaceFirst("^dfra ?", "");
    if (!line.getSubcommands().isEmpty()
        && e instanceof UnmatchedArgumentException unmatched
        && !unmatched.isUnknownOption()) {
      String wrong = (asked + " " + unmatched.getUnmatched().get(0)).strip();
      String there = "; there is " + String.join(", ", verbs(line));
      return "there is no verb \""
          + wrong
          + "\""
          + NearestName.hint(unmatched.getUnmatched().get(0), verbs(line), there);
    }
    boolean isVerbMissing =
        !line.getSubcommands().isEmpty() && !(line.getCommand() instanceof Callable);
    if (isVerbMissing && e.getClass() == ParameterException.class) {
      return asked + " needs a verb; there is " + String.join(", ", verbs(line));
    }
    String first = String.valueOf(e.getMessage()).lines().findFirst().orElse("");
    return rephrase(first) + "; see: " + CommandName.current() + " " + (asked + " --help").strip();
  }

  /**
   * Picocli's message for an invalid value contains types and positions, which do not help the
   * user.
   */
  private static String rephrase(String message) {
    Matcher value = VALUE.matcher(message);
    if (!value.matches()) {
      boolean isName = message.matches("\\p{Lu}{2}.*"); // of a picocli variable
      return message.isEmpty() || isName
          ? message
          : message.substring(0, 1).toLowerCase(Locale.ROOT) + message.substring(1);
    }
    String name = value.group("option") == null ? value.group("label") : value.group("option");
    if (value.group("number") != null) {
      String number = value.group("type").equals("double") ? "a number" : "a whole number";
      return name + "=" + value.group("number") + " is not " + number;
    }
    List<String> choices = List.of(value.group("choices").toLowerCase(Locale.ROOT).split(", "));
    String written = value.group("written");
    return name + " cannot be \"" + written + "\"; it is one of " + String.join(", ", choices);
  }

  private static List<String> verbs(CommandLine line) {
    Stream<String> ofScript = line.getParent() == null ? ScriptVerbs.names().stream() : Stream.of();
    return Stream.concat(line.getSubcommands().keySet().stream(), ofScript).sorted().toList();
  }
}
