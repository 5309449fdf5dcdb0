package org.dfra.benchmarks.task;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.lang.reflect.Constructor;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.dfra.river.security.SecureProcess;

/**
 * Runs a {@link Task} in a separate process, which ends with the process that started it. It has
 * the identity that the system property {@value SecureProcess#PROPERTY} names, if it is set.
 */
final class TaskMain {

  private static final int FAILED = 1;
  private static final int STARTER_ENDED = 3;

  private TaskMain() {}

  /** Arguments: the task's class, and the task's own. */
  public static void main(String[] args) {
    ProcessHandle.current()
        .parent()
        .ifPresent(
            starter -> {
              var unused = starter.onExit().thenRun(() -> Runtime.getRuntime().halt(STARTER_ENDED));
            });
    PrintStream out =
        new PrintStream(new FileOutputStream(FileDescriptor.out), true, StandardCharsets.UTF_8);
    System.setOut(System.err);
    try {
      Object unused = SecureProcess.installFromProperty();
      Constructor<? extends Task> constructor =
          Class.forName(args[0]).asSubclass(Task.class).getDeclaredConstructor();
      constructor.setAccessible(true); // a task need not be public
      Task task = constructor.newInstance();
      task.run(Arrays.copyOfRange(args, 1, args.length), out);
    } catch (Exception | Error e) {
      e.printStackTrace();
      System.exit(FAILED);
    }
    System.exit(0);
  }
}
