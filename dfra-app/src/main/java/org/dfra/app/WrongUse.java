package org.dfra.app;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Tells in one sentence what was asked wrongly, and where to read how it is asked. */
final class WrongUse implements IParameterExceptionHandler {

  @Override
  public int handleParseException(ParameterException e, String[] args) {
    CommandLine line = e.getCommandLine();
    boolean isNothingAsked = line.getParent() == null && args.length == 0;
    if (isNothingAsked) {
      line.usage(line.getErr());
    } else {
      line.getErr().println("dfra: " + sentence(e, line));
    }
    return line.getCommandSpec().exitCodeOnInvalidInput();
  }

  private static String sentence(ParameterException e, CommandLine line) {
    String asked = line.getCommandSpec().qualifiedName(" ").replaceFirst("^dfra ?", "");
    if (!line.getSubcommands().isEmpty()
        && e instanceof UnmatchedArgumentException unmatched
        && !unmatched.isUnknownOption()) {
      String wrong = (asked + " " + unmatched.getUnmatched().get(0)).strip();
      return "there is no verb \"" + wrong + "\"; there is " + String.join(", ", verbs(line));
    }
    boolean isVerbMissing =
        !line.getSubcommands().isEmpty() && !(line.getCommand() instanceof Callable);
    if (isVerbMissing && e.getClass() == ParameterException.class) {
      return asked + " needs a verb; there is " + String.join(", ", verbs(line));
    }
    String first = String.valueOf(e.getMessage()).lines().findFirst().orElse("");
    return first.substring(0, 1).toLowerCase(Locale.ROOT)
        + first.substring(1)
        + "; see: ./dfra "
        + (asked + " --help").strip();
  }

  private static List<String> verbs(CommandLine line) {
    Stream<String> ofScript = line.getParent() == null ? ScriptVerbs.names().stream() : Stream.of();
    return Stream.concat(line.getSubcommands().keySet().stream(), ofScript).sorted().toList();
  }
}
