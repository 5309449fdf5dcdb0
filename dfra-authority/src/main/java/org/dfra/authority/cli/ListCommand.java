package org.dfra.authority.cli;

import java.time.Instant;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.authority.Authority;
import org.dfra.authority.IssuedCertificate;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra security list}. */
@Command(name = "list", description = "Lists the certificates that the authority has issued.")
final class ListCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private AuthorityFolderOption place;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Override
  public Integer call() throws Exception {
    List<IssuedCertificate> all = Authority.issued(place.in(state.folder()));
    Instant now = Instant.now();
    Table table = new Table("MEMBER", "STATE", "UNTIL", "SERIAL", "WHY");
    for (IssuedCertificate each : all) {
      table.row(
          each.owner(),
          each.stateAt(now),
          each.until(),
          each.serial(),
          each.reason() == null ? "" : each.reason());
    }
    answer.table(all, table, "The authority has issued no certificate.");
    return ExitCode.SUCCESS;
  }
}
