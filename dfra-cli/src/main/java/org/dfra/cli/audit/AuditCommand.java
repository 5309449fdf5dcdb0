package org.dfra.cli.audit;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra audit}; without a subcommand it shows the trail. */
@Command(
    name = "audit",
    description =
        "Shows who called what on this computer's robots and what was refused, and verifies that"
            + " nobody has changed these records. Without a subcommand it is show.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {ShowCommand.class, VerifyCommand.class})
public final class AuditCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ShowOptions options;

  @Override
  public Integer call() throws Exception {
    return TrailPrinter.show(options);
  }
}
