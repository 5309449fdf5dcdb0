package org.dfra.river.server;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Closes the modules of a process when the process is terminated, as phoenix does with its groups.
 * A device must be stopped then as after any other shutdown, and history counts no failure.
 *
 * <pre>
 *   SIGTERM --&gt; halt what moves the robot, all at once --&gt; close all modules, all at once
 * </pre>
 *
 * <p>All modules share one shutdown hook, so that effectors halt before anything else uses the
 * processor. An effector with a blocked driver delays the second step by at most {@link
 * #HALT_TIMEOUT}.
 */
final class ModuleShutdownHook implements AutoCloseable {

  /** How long the other modules wait until the robot is halted. */
  static final Duration HALT_TIMEOUT = Duration.ofMillis(500);

  private static final Logger LOG = LoggerFactory.getLogger(ModuleShutdownHook.class);

  private static final List<ModuleShutdownHook> OPEN = new ArrayList<>(); // guarded by itself

  @GuardedBy("OPEN")
  private static boolean hooked;

  @GuardedBy("OPEN")
  private static boolean ending;

  private final ModuleServer<?> server;

  private ModuleShutdownHook(ModuleServer<?> server) {
    this.server = server;
  }

  /**
   * Registers a server to be closed when the process exits, unless this is closed before.
   *
   * @throws IllegalStateException if the process is being terminated already
   */
  static ModuleShutdownHook register(ModuleServer<?> server) {
    ModuleShutdownHook end = new ModuleShutdownHook(server);
    synchronized (OPEN) {
      if (ending) {
        throw new IllegalStateException("its process is being terminated");
      }
      if (!hooked) {
        hooked = true;
        Runtime.getRuntime()
            .addShutdownHook(new Thread(ModuleShutdownHook::shutDownAll, "dfra-end"));
      }
      OPEN.add(end);
    }
    return end;
  }

  /** Halts what moves the robot, then closes every module that is still open. */
  private static void shutDownAll() {
    List<ModuleServer<?>> servers = new ArrayList<>();
    synchronized (OPEN) {
      ending = true;
      OPEN.forEach(each -> servers.add(each.server));
    }
    shutDownAll(servers);
  }

  /** Halts, then closes these servers. */
  static void shutDownAll(List<? extends ModuleServer<?>> servers) {
    List<Thread> halting = each(servers, "halt", ModuleServer::halt);
    await(halting, System.nanoTime() + HALT_TIMEOUT.toNanos());
    List<Thread> closing = each(servers, "end", ModuleServer::close);
    await(closing, Long.MAX_VALUE);
    await(halting, Long.MAX_VALUE); // the virtual machine ends with this thread
  }

  private static List<Thread> each(
      List<? extends ModuleServer<?>> servers, String step, Consumer<ModuleServer<?>> task) {
    List<Thread> threads = new ArrayList<>();
    for (ModuleServer<?> server : servers) {
      Thread thread = new Thread(() -> run(server, task), server.path() + " " + step);
      try {
        thread.start();
        threads.add(thread);
      } catch (OutOfMemoryError e) { // no room for one more thread; use this one
        run(server, task);
      }
    }
    return threads;
  }

  private static void run(ModuleServer<?> server, Consumer<ModuleServer<?>> task) {
    try {
      task.accept(server);
    } catch (RuntimeException | Error e) { // the others must be closed as well
      LOG.error("{} did not end cleanly with its process: {}", server.path(), e.toString(), e);
    }
  }

  /**
   * @param deadline {@link System#nanoTime}; {@link Long#MAX_VALUE} for no limit
   */
  private static void await(List<Thread> threads, long deadline) {
    try {
      for (Thread thread : threads) {
        if (deadline == Long.MAX_VALUE) {
          thread.join();
        } else {
          long millis = (deadline - System.nanoTime()) / 1_000_000;
          if (millis > 0) {
            thread.join(millis);
          }
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // not expected here; continue at once
    }
  }

  @Override
  public void close() {
    synchronized (OPEN) {
      OPEN.remove(this);
    }
  }
}
