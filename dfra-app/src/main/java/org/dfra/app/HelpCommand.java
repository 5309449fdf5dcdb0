package org.dfra.app;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.app.terminal.ExitCode;
import org.dfra.text.PrintableText;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import picocli.CommandLine.UnmatchedArgumentException;

/** {@code ./dfra help}. Unlike picocli's own help command it also explains nested subcommands. */
@Command(name = "help", description = "Explains a verb, or lists all of them.")
final class HelpCommand implements Callable<Integer> {

  @Parameters(
      paramLabel = "VERB",
      arity = "0..*",
      description = "The verb, and the verb of that verb if it has some; without any, all.")
  private List<String> verbs = new ArrayList<>();

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  @Override
  public Integer call() {
    CommandLine line = spec.parent().commandLine();
    for (String verb : verbs) {
      CommandLine next = line.getSubcommands().get(verb);
      if (next == null && line.getParent() == null && ScriptVerbs.names().contains(verb)) {
        spec.commandLine()
            .getOut()
            .println(PrintableText.line("The script explains it: ./dfra " + verb + " --help"));
        return ExitCode.SUCCESS;
      } else if (next == null) {
        throw new UnmatchedArgumentException(line, List.of(verb));
      }
      line = next;
    }
    line.usage(spec.commandLine().getOut());
    return ExitCode.SUCCESS;
  }
}
