package org.dfra.cli.audit;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra audit show}. */
@Command(
    name = "show",
    description = "Shows the records of all processes, merged by time, one per line.",
    footer = {
      "",
      "Permitted calls that only read have one record for each caller, method and interval.",
      "Only the records of robots of this computer are shown: each computer has its own."
    })
final class ShowCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ShowOptions options;

  @Override
  public Integer call() throws Exception {
    return TrailPrinter.show(options);
  }
}
