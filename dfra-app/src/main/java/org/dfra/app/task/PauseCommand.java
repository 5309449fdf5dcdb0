package org.dfra.app.task;

import java.util.concurrent.Callable;
import org.dfra.behavior.Behavior;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra task pause}. */
@Command(
    name = "pause",
    description = "Has robots stand until they are told to go on.",
    footer = {"", "Who is at nothing is left alone."})
final class PauseCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TaskRobotOptions searches;

  @Override
  public Integer call() throws Exception {
    return new TaskBroadcast(searches).send(Behavior::pause);
  }
}
