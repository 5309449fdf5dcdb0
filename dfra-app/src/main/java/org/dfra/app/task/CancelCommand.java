package org.dfra.app.task;

import java.util.concurrent.Callable;
import org.dfra.behavior.Behavior;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra task cancel}. */
@Command(
    name = "cancel",
    description = "Has robots give up what they are at; they stand.",
    footer = {"", "Who is at nothing is left alone."})
final class CancelCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TaskRobotOptions searches;

  @Override
  public Integer call() throws Exception {
    return new TaskBroadcast(searches).send(Behavior::cancel);
  }
}
