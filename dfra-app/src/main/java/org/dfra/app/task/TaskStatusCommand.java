package org.dfra.app.task;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra task status}. */
@Command(name = "status", description = "Shows how far each robot is with what it was told to do.")
final class TaskStatusCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TaskRobotOptions searches;

  @Override
  public Integer call() throws Exception {
    return new TaskBroadcast(searches).send(search -> {});
  }
}
