package org.dfra.app.recruit;

import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra recruit status}. */
@Command(
    name = "status",
    description = "Shows which robots help, and which are held and answer no call.",
    footer = {
      "",
      "A robot is held after somebody stopped it: by a pause, a cancel, a set brake or an",
      "emergency stop. It stays held until its search is resumed, it gets another goal, or",
      "./dfra recruit resume."
    })
final class RecruitStatusCommand implements Callable<Integer> {

  @Parameters(
      paramLabel = "ROBOT",
      arity = "0..*",
      description = "Only these robots (default: all that have a recruitment agent).")
  private List<String> robots = List.of();

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private RecruitmentAgentOptions agents;

  @Override
  public Integer call() throws Exception {
    return agents.ask(robots, agent -> {}).code();
  }
}
