package org.dfra.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.cli.completion.ScriptVerbs;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.text.PrintableText;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import picocli.CommandLine.UnmatchedArgumentException;

/** {@code ./dfra help}. Unlike picocli's own help command it also explains nested subcommands. */
@Command(name = "help", description = "Explains a command, or lists all of them.")
final class HelpCommand implements Callable<Integer> {

  @Parameters(
      paramLabel = "COMMAND",
      arity = "0..*",
      description = "The command, and its subcommand if it has any (default: all commands).")
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
            .println(
                PrintableText.line(
                    "The script explains it: " + CommandName.current() + " " + verb + " --help"));
        return ExitCode.SUCCESS;
      } else if (next == null) {
        ProvidedCommands.installed()
            .missing(verbs.toArray(String[]::new))
            .ifPresent(HelpCommand::failNotInstalled);
        throw new UnmatchedArgumentException(line, List.of(verb));
      }
      line = next;
    }
    line.usage(spec.commandLine().getOut());
    return ExitCode.SUCCESS;
  }

  private static void failNotInstalled(String sentence) {
    throw new CommandFailure(ExitCode.NOT_INSTALLED, sentence);
  }
}
