package org.dfra.benchmarks.task;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dfra.river.bootstrap.JvmCommand;
import org.jspecify.annotations.Nullable;

/**
 * A {@link Task} in a separate process, with this JVM's class path. Its lines are read and kept as
 * they are printed.
 *
 * <p>Two threads read its output and its log until it ends. Thread-safe.
 */
public final class TaskProcess implements AutoCloseable {

  private static final String HEAP = "-Xmx128m";
  private static final Duration END = Duration.ofSeconds(10);
  private static final int LOG_CHARACTERS = 100_000;

  private final String name;
  private final Process process;

  @GuardedBy("this")
  private final List<String> lines = new ArrayList<>();

  private final StringBuilder log = new StringBuilder(); // guarded by itself

  // index of the next line to await
  @GuardedBy("this")
  private int next;

  // whether the output has ended
  @GuardedBy("this")
  private boolean ended;

  // see killWithThis
  @GuardedBy("this")
  private @Nullable ProcessHandle daemon;

  @GuardedBy("this")
  private @Nullable Thread lastResort;

  private TaskProcess(String name, Process process) {
    this.name = name;
    this.process = process;
  }

  /**
   * Starts a task.
   *
   * @param args for the task
   * @throws IOException if there is no such program
   */
  public static TaskProcess start(Class<? extends Task> task, String... args) throws IOException {
    return start(List.of(), List.of(), task, args);
  }

  /**
   * Starts a task.
   *
   * @param prefix a program that becomes the task's process, with its arguments, such as {@code
   *     taskset -c 0} or {@code ip netns exec NAME}; empty for none
   * @param options further JVM options; a later one takes precedence, so that {@code -Xmx1g}
   *     replaces the default of 128 MB
   * @param args for the task
   * @throws IOException if there is no such program
   */
  public static TaskProcess start(
      List<String> prefix, List<String> options, Class<? extends Task> task, String... args)
      throws IOException {
    List<String> command = new ArrayList<>(prefix);
    command.add(JvmCommand.java());
    command.addAll(JvmCommand.options());
    command.add(HEAP);
    command.addAll(options);
    command.add(TaskMain.class.getName());
    command.add(task.getName());
    command.addAll(List.of(args));
    TaskProcess started =
        new TaskProcess(task.getSimpleName(), new ProcessBuilder(command).start());
    started.thread("output", started::readLines);
    started.thread("log", started::readLog);
    return started;
  }

  private void thread(String of, Runnable role) {
    Thread thread = new Thread(role, of + " of " + name + ", process " + pid());
    thread.setDaemon(true);
    thread.start();
  }

  private void readLines() {
    try (BufferedReader in = process.inputReader()) {
      for (String line; (line = in.readLine()) != null; ) {
        synchronized (this) {
          lines.add(line);
          notifyAll();
        }
      }
    } catch (IOException e) {
      log(e.toString());
    } finally {
      synchronized (this) {
        ended = true;
        notifyAll();
      }
    }
  }

  private void readLog() {
    try (BufferedReader in = process.errorReader()) {
      for (String line; (line = in.readLine()) != null; ) {
        log(line);
      }
    } catch (IOException e) {
      log(e.toString());
    }
  }

  /** Keeps the end of the log only. */
  private void log(String line) {
    synchronized (log) {
      log.append(line).append('\n');
      if (log.length() > LOG_CHARACTERS) {
        log.delete(0, LOG_CHARACTERS / 2);
      }
    }
  }

  /**
   * The next line with this prefix; skips the lines before it.
   *
   * @param beginning the prefix; empty for any line
   * @param patience timeout
   * @throws IOException if there is none before the timeout or the process ends before; its message
   *     contains the log
   */
  public synchronized String awaitLine(String beginning, Duration patience)
      throws IOException, InterruptedException {
    long end = System.nanoTime() + patience.toNanos();
    while (true) {
      while (next < lines.size()) {
        String line = lines.get(next++);
        if (line.startsWith(beginning)) {
          return line;
        }
      }
      long left = end - System.nanoTime();
      if (ended || left <= 0) {
        throw new IOException(
            "%s, process %d, %s \"%s\"; its log: %s%nits lines: %s"
                .formatted(
                    name,
                    pid(),
                    ended ? "ended and did not print" : "did not print within " + patience,
                    beginning,
                    log(),
                    lines));
      }
      TimeUnit.NANOSECONDS.timedWait(this, left);
    }
  }

  /** Writes a line to the task's {@code System.in}. */
  public void write(String line) throws IOException {
    Writer to = process.outputWriter();
    to.write(line + "\n");
    to.flush();
  }

  /** All lines so far. */
  public synchronized List<String> lines() {
    return List.copyOf(lines);
  }

  /** Its log so far; of a long log the end. */
  public String log() {
    synchronized (log) {
      return log.toString();
    }
  }

  /** Its process ID. */
  public long pid() {
    return process.pid();
  }

  /**
   * Makes a process that the task started end with this one, and with this JVM, together with all
   * its child processes: a daemon such as phoenix, which outlives its parent process. At most one.
   *
   * @param pid its process ID
   * @throws IOException if there is no such process
   */
  public synchronized void killWithThis(long pid) throws IOException {
    if (daemon != null) {
      throw new IllegalStateException(name + " has another daemon, process " + daemon.pid());
    }
    ProcessHandle found =
        ProcessHandle.of(pid).orElseThrow(() -> new IOException("there is no process " + pid));
    Thread hook = new Thread(() -> killAll(found), "ends process " + pid);
    Runtime.getRuntime().addShutdownHook(hook);
    daemon = found;
    lastResort = hook;
  }

  /** Its child processes come last: otherwise it would restart them. */
  private static List<ProcessHandle> killAll(ProcessHandle daemon) {
    List<ProcessHandle> all = Stream.concat(Stream.of(daemon), daemon.descendants()).toList();
    all.forEach(ProcessHandle::destroyForcibly);
    return all;
  }

  private synchronized void killDaemon() {
    if (daemon == null || lastResort == null) {
      return;
    }
    CompletableFuture<?>[] ends =
        killAll(daemon).stream().map(ProcessHandle::onExit).toArray(CompletableFuture<?>[]::new);
    var unused =
        CompletableFuture.allOf(ends)
            .completeOnTimeout(null, END.toMillis(), TimeUnit.MILLISECONDS)
            .join();
    Runtime.getRuntime().removeShutdownHook(lastResort);
    daemon = null;
    lastResort = null;
  }

  /** Whether it still runs. */
  public boolean isAlive() {
    return process.isAlive();
  }

  /**
   * Waits until it ends by itself.
   *
   * @param patience timeout
   * @return its exit code
   * @throws IOException if it still runs then; its message contains the log
   */
  public int awaitEnd(Duration patience) throws IOException, InterruptedException {
    if (!process.waitFor(patience.toMillis(), TimeUnit.MILLISECONDS)) {
      throw new IOException(
          "%s, process %d, still runs after %s; its log:%n%s"
              .formatted(name, pid(), patience, log()));
    }
    return process.exitValue();
  }

  /** Kills this process with SIGKILL, and its daemon if it has one. Idempotent. */
  @Override
  public void close() throws InterruptedException {
    process.destroyForcibly();
    killDaemon();
    if (!process.waitFor(END.toMillis(), TimeUnit.MILLISECONDS)) {
      throw new IllegalStateException("process " + pid() + " does not end after SIGKILL");
    }
  }
}
