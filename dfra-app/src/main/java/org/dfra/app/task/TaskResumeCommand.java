package org.dfra.app.task;

import java.util.concurrent.Callable;
import org.dfra.behavior.Behavior;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra task resume}. */
@Command(
    name = "resume",
    description =
        "Has robots go on with what they paused. Releases a parking brake that is set: see first"
            + " that they may move.",
    footer = {"", "Who has not paused is left alone."})
final class TaskResumeCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TaskRobotOptions searches;

  @Override
  public Integer call() throws Exception {
    return new TaskBroadcast(searches).send(Behavior::resume);
  }
}
