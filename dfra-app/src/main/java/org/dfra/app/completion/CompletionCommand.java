package org.dfra.app.completion;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.dfra.app.ScriptVerbs;
import org.dfra.app.terminal.ExitCode;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code ./dfra completion}. */
@Command(
    name = "completion",
    description = "Prints the script that completes dfra in a shell.",
    footer = {
      "",
      "For the shell that is open: source <(./dfra completion bash).",
      "For every shell to come: see docs/how-to/complete-commands.md."
    })
public final class CompletionCommand implements Callable<Integer> {

  private static final String NAME = "dfra";

  /** The supported shells. One script serves both: zsh reads the Bash script by bashcompinit. */
  enum Shell {
    bash,
    zsh
  }

  @Parameters(paramLabel = "SHELL", description = "${COMPLETION-CANDIDATES}.")
  @SuppressWarnings({"NullAway.Init", "UnusedVariable"}) // set by picocli; same for both
  private Shell shell;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  @Override
  public Integer call() {
    // A separate command line, since the running one does not contain the script's subcommands.
    CommandLine whole = new CommandLine(spec.root().userObject());
    ScriptVerbs.addTo(whole);
    PrintWriter out = spec.commandLine().getOut();
    out.print(AutoComplete.bash(NAME, whole));
    out.flush();
    return ExitCode.SUCCESS;
  }
}
