package org.dfra.app;

import java.util.List;
import java.util.Locale;
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
    boolean isVerbMissing = line.getParent() == null && args.length == 0;
    if (isVerbMissing) {
      line.usage(line.getErr());
    } else {
      line.getErr().println("dfra: " + sentence(e, line));
    }
    return line.getCommandSpec().exitCodeOnInvalidInput();
  }

  private static String sentence(ParameterException e, CommandLine line) {
    boolean isAboutVerbs = line.getParent() == null;
    if (isAboutVerbs
        && e instanceof UnmatchedArgumentException unmatched
        && !unmatched.isUnknownOption()) {
      return "there is no verb \""
          + unmatched.getUnmatched().get(0)
          + "\"; there is "
          + String.join(", ", verbs(line));
    }
    String first = String.valueOf(e.getMessage()).lines().findFirst().orElse("");
    return first.substring(0, 1).toLowerCase(Locale.ROOT)
        + first.substring(1)
        + "; see: ./dfra "
        + (isAboutVerbs ? "help" : "help " + line.getCommandName());
  }

  private static List<String> verbs(CommandLine line) {
    return Stream.concat(line.getSubcommands().keySet().stream(), Stream.of("test"))
        .sorted()
        .toList();
  }
}
