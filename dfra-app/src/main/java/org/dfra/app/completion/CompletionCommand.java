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

  /** The shells that are known. One script serves them: zsh reads bash's by its bashcompinit. */
  enum Shell {
    bash,
    zsh
  }

  @Parameters(paramLabel = "SHELL", description = "${COMPLETION-CANDIDATES}.")
  @SuppressWarnings({"NullAway.Init", "UnusedVariable"}) // picocli sets it; both get the same
  private Shell shell;

  @Spec
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private CommandSpec spec;

  @Override
  public Integer call() {
    // A command line of its own, since the verbs of the script are no part of the one that runs.
    CommandLine whole = new CommandLine(spec.root().userObject());
    ScriptVerbs.addTo(whole);
    PrintWriter out = spec.commandLine().getOut();
    out.print(AutoComplete.bash(NAME, whole));
    out.flush();
    return ExitCode.SUCCESS;
  }
}
