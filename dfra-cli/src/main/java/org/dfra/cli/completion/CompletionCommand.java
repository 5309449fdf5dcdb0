package org.dfra.cli.completion;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.ExitCode;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code ./dfra completion}. */
@Command(
    name = "completion",
    description = "Prints a script with which a shell completes dfra commands.",
    footer = {
      "",
      "For the current shell: source <("
          + CommandName.IN_HELP
          + " completion bash). For all new shells: see",
      "docs/how-to/complete-commands.md."
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
    CommandLine whole = spec.root().commandLine();
    ScriptVerbs.addTo(whole);
    PrintWriter out = spec.commandLine().getOut();
    out.print(AutoComplete.bash(NAME, whole));
    out.flush();
    return ExitCode.SUCCESS;
  }
}
