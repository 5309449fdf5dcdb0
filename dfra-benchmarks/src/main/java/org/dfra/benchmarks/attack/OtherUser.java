package org.dfra.benchmarks.attack;

import java.io.File;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dfra.benchmarks.task.Task;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.river.bootstrap.JvmCommand;

/**
 * The user {@code nobody} on the robot's own computer, without permissions. Only root can start
 * processes as another user.
 *
 * <p>Often only the owner can read the classes of a build, so {@code nobody} gets links or copies.
 */
public final class OtherUser {

  /** As the system writes it. */
  public static final String NAME = "nobody";

  /** The missing requirement if {@link #find} returns empty. */
  public static final String NEEDS =
      "root and setpriv, and java and a temporary folder that user " + NAME + " may use";

  private static final int ID = 65_534;
  private static final List<String> BECOME =
      List.of("setpriv", "--reuid=" + ID, "--regid=" + ID, "--clear-groups");
  private static final String BOOT = "-Xbootclasspath/a:";

  private final List<String> options;

  private OtherUser(List<String> options) {
    this.options = options;
  }

  /**
   * The user; empty if this process cannot start others as that user.
   *
   * @param folder an empty folder for the classes; it and its parent become readable by all users
   * @throws IOException if the classes cannot be copied, or a command of the user does not end
   */
  public static Optional<OtherUser> find(Path folder) throws IOException, InterruptedException {
    if (!run(List.of("true"))) {
      return Optional.empty();
    }
    open(folder);
    open(folder.toAbsolutePath().resolve("..").normalize());
    if (!run(List.of("ls", folder.toString()))) {
      return Optional.empty();
    }
    OtherUser user = new OtherUser(options(folder));
    List<String> version = new ArrayList<>(List.of(JvmCommand.java()));
    version.addAll(user.options);
    version.add("-version");
    return run(version) ? Optional.of(user) : Optional.empty();
  }

  /**
   * Makes a folder writable by all users.
   *
   * @throws IOException if it is not owned by this user
   */
  public static void share(Path folder) throws IOException {
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxrwxrwx"));
  }

  /** Whether the user can run a command. */
  private static boolean run(List<String> arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(BECOME);
    command.addAll(arguments);
    try {
      Process process =
          new ProcessBuilder(command)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      if (!process.waitFor(1, TimeUnit.MINUTES)) {
        process.destroyForcibly();
        throw new IOException(command + " does not end");
      }
      return process.exitValue() == 0;
    } catch (IOException e) {
      if (e.getMessage() != null && e.getMessage().contains("No such file")) {
        return false; // setpriv is not installed
      }
      throw e;
    }
  }

  /**
   * Runs a task as this user.
   *
   * @throws IOException if it cannot be started
   */
  public TaskProcess start(Class<? extends Task> task, String... args) throws IOException {
    return start(List.of(), task, args);
  }

  /**
   * Runs a task as this user.
   *
   * @param prefix a program that becomes the task's process, with its arguments, as for {@link
   *     TaskProcess#start(List, List, Class, String...)}
   * @throws IOException if it cannot be started
   */
  public TaskProcess start(List<String> prefix, Class<? extends Task> task, String... args)
      throws IOException {
    List<String> command = new ArrayList<>(prefix);
    command.addAll(BECOME);
    return TaskProcess.start(command, options, task, args);
  }

  /**
   * JVM options with class paths that this user can read; unreadable entries are copied or linked.
   */
  private static List<String> options(Path folder) throws IOException {
    List<String> options = new ArrayList<>();
    List<String> own = JvmCommand.options();
    for (int i = 0; i < own.size(); i++) {
      if (own.get(i).startsWith(BOOT)) {
        options.add(BOOT + readable(own.get(i).substring(BOOT.length()), folder));
      } else if (own.get(i).equals("-cp")) {
        options.addAll(List.of("-cp", readable(own.get(i + 1), folder)));
      }
    }
    return options;
  }

  private static String readable(String path, Path folder) throws IOException {
    List<String> entries = new ArrayList<>();
    for (String each : path.split(File.pathSeparator, -1)) {
      Path entry = Path.of(each);
      if (Files.exists(entry)) {
        Path own = Files.createTempDirectory(folder, "classes");
        Path to = own.resolve(String.valueOf(entry.getFileName()));
        copy(entry, to);
        open(own);
        entries.add(to.toString());
      }
    }
    return String.join(File.pathSeparator, entries);
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      for (Path each : files.toList()) {
        Path target = to.resolve(from.relativize(each).toString());
        if (Files.isDirectory(each)) {
          Files.createDirectories(target);
          open(target);
        } else {
          linkOrCopy(each, target);
        }
      }
    }
  }

  private static void linkOrCopy(Path from, Path to) throws IOException {
    boolean isReadable =
        PosixFilePermissions.toString(Files.getPosixFilePermissions(from)).charAt(6) == 'r';
    try {
      if (isReadable) {
        Files.createLink(to, from);
        return;
      }
    } catch (FileSystemException e) { // on another file system
      Files.deleteIfExists(to);
    }
    Files.copy(from, to);
    Files.setPosixFilePermissions(to, PosixFilePermissions.fromString("rw-r--r--"));
  }

  private static void open(Path folder) throws IOException {
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
  }
}
