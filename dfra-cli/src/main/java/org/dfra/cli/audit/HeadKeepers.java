package org.dfra.cli.audit;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.core.audit.KeptHead;
import org.dfra.core.host.CommandName;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.security.news.NewsExchange;
import org.jspecify.annotations.Nullable;

/** Robots that keep heads of audit trails. */
final class HeadKeepers {

  private final TeamOptions options;

  HeadKeepers(TeamOptions options) {
    this.options = options;
  }

  /**
   * The heads that robots keep.
   *
   * @param robots their names; each must answer, since a missing answer would look like no head
   * @param owners whose heads, as texts of members
   * @throws CommandFailure if a robot does not answer, or keeps none
   */
  List<KeptHead> ask(List<String> robots, Set<String> owners)
      throws IOException, InterruptedException {
    List<KeptHead> heads = new ArrayList<>();
    try (TeamDirectory team = options.open()) {
      for (String robot : robots) {
        List<KeptHead> kept = ask(robot, process(team, robot), owners);
        if (kept.isEmpty()) {
          throw new CommandFailure(
              ExitCode.NOT_FOUND, "robot " + robot + " keeps no head of " + owners);
        }
        heads.addAll(kept);
      }
    }
    return heads;
  }

  private static List<KeptHead> ask(String robot, PeerAddress process, Set<String> owners) {
    List<KeptHead> heads = new ArrayList<>();
    try {
      for (String each : owners) {
        heads.addAll(NewsExchange.keptBy(process, each));
      }
      return heads;
    } catch (IOException | RuntimeException e) {
      throw new CommandFailure(
          ExitCode.FAILED, "robot " + robot + " was not asked for heads: " + e.getMessage(), e);
    }
  }

  private static PeerAddress process(TeamDirectory team, String robot) throws InterruptedException {
    for (ModuleListing<Module> each :
        team.await(ModuleQuery.of(Module.class).robot(robot), found -> true)) {
      if (each.module() instanceof ModuleProxy<?> module) {
        @Nullable PeerAddress address = PeerAddress.of(module.server());
        if (address != null) {
          return address;
        }
      }
    }
    throw new CommandFailure(
        ExitCode.NOT_FOUND,
        "robot "
            + robot
            + " has no module that answers; "
            + CommandName.current()
            + " module list shows those of the team, and --wait 10 waits longer");
  }
}
