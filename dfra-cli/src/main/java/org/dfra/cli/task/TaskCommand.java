package org.dfra.cli.task;

import java.util.concurrent.Callable;
import org.dfra.behavior.Behavior;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra task}: the goals of robots. */
@Command(
    name = "task",
    description = "Gives tasks to robots, and shows their progress.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {
      SubmitCommand.class,
      TaskCommand.TaskStatusCommand.class,
      TaskCommand.PauseCommand.class,
      TaskCommand.TaskResumeCommand.class,
      TaskCommand.CancelCommand.class
    })
public final class TaskCommand {

  /** {@code ./dfra task status}. */
  @Command(name = "status", description = "Shows each robot's task and its progress.")
  static final class TaskStatusCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private TaskRobotOptions searches;

    @Override
    public Integer call() throws Exception {
      return new TaskBroadcast(searches).send(search -> {});
    }
  }

  /** {@code ./dfra task pause}. */
  @Command(
      name = "pause",
      description = "Pauses the robots' tasks: the robots stop until resumed.",
      footer = {"", "Idle robots are unaffected."})
  static final class PauseCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private TaskRobotOptions searches;

    @Override
    public Integer call() throws Exception {
      return new TaskBroadcast(searches).send(Behavior::pause);
    }
  }

  /** {@code ./dfra task resume}. */
  @Command(
      name = "resume",
      description =
          "Resumes paused tasks. Releases a parking brake that is set: check first that the robots"
              + " may move.",
      footer = {"", "Robots that are not paused are unaffected."})
  static final class TaskResumeCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private TaskRobotOptions searches;

    @Override
    public Integer call() throws Exception {
      return new TaskBroadcast(searches).send(Behavior::resume);
    }
  }

  /** {@code ./dfra task cancel}. */
  @Command(
      name = "cancel",
      description = "Cancels the robots' tasks: the robots stop.",
      footer = {"", "Idle robots are unaffected."})
  static final class CancelCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private TaskRobotOptions searches;

    @Override
    public Integer call() throws Exception {
      return new TaskBroadcast(searches).send(Behavior::cancel);
    }
  }
}
