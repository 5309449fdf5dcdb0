package org.dfra.sim.device;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/**
 * A serial port connected to an emulated device, for drivers that require a {@code serial:} link:
 * {@code socat} connects a pseudo-terminal to the emulator's TCP port.
 *
 * <p>While the device's {@link Cable} is unplugged the port does not exist, as with a USB adapter;
 * it reappears under the same name.
 *
 * <p>{@link #start} starts one thread, {@code name terminal}, which owns the current socat process;
 * {@link #close} ends both and removes the port's folder. Both are idempotent.
 */
public final class PseudoTerminal implements AutoCloseable {

  private static final long PATIENCE_SECONDS = 20;
  private static final long RETRY_MILLIS = 100; // real time

  /** socat's message when both its ends are open. */
  private static final String READY = "starting data transfer loop";

  private final String name;
  private final DeviceEmulator emulator;
  private final String programs;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();

  @GuardedBy("lock")
  private @Nullable Path port;

  @GuardedBy("lock")
  private @Nullable Thread thread;

  @GuardedBy("lock")
  private @Nullable Process socat;

  @GuardedBy("lock")
  private boolean closed;

  @GuardedBy("lock")
  private boolean ready;

  @GuardedBy("lock")
  private String fault = "socat has printed nothing";

  /**
   * @param name name of the port's file
   * @param emulator of the device; started, and not closed before this
   */
  public PseudoTerminal(String name, DeviceEmulator emulator) {
    this(name, emulator, System.getenv().getOrDefault("PATH", ""));
  }

  /**
   * @param programs the folders in which socat is searched
   */
  PseudoTerminal(String name, DeviceEmulator emulator, String programs) {
    this.name = name;
    this.emulator = emulator;
    this.programs = programs;
  }

  /**
   * Creates the port; returns when it exists.
   *
   * @throws IOException if socat is not installed or fails
   * @throws IllegalStateException if the emulator does not listen
   */
  public void start() throws IOException {
    lock.lock();
    try {
      if (closed) {
        throw new IllegalStateException("this terminal was closed; create a new one");
      }
      if (thread != null) {
        return;
      }
      Path program = program();
      int leadsTo = emulator.port();
      Path made = Files.createTempDirectory("dfra-port").resolve(name);
      port = made;
      Thread keeper = new Thread(() -> keep(program, leadsTo, made), name + " terminal");
      keeper.setDaemon(true);
      thread = keeper;
      keeper.start();
      awaitReady();
    } finally {
      lock.unlock();
    }
  }

  private Path program() throws IOException {
    for (String folder : programs.split(File.pathSeparator, -1)) {
      Path program = Path.of(folder, "socat");
      if (!folder.isEmpty() && Files.isExecutable(program)) {
        return program;
      }
    }
    throw new IOException(
        "a pseudo-terminal needs the program socat, which was not found in PATH ("
            + programs
            + "); install it, or use the link "
            + emulator.url());
  }

  @GuardedBy("lock")
  private void awaitReady() throws IOException {
    long left = TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
    try {
      while (!ready && left > 0) {
        left = changed.awaitNanos(left);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (!ready) {
      throw new IOException(
          port + " does not exist after " + PATIENCE_SECONDS + " s; socat printed: " + fault);
    }
  }

  /** The link for a driver: {@code serial:file}. */
  public String url() {
    lock.lock();
    try {
      if (port == null) {
        throw new IllegalStateException("there is no port yet; start the terminal first");
      }
      return "serial:" + port;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() {
    Thread keeper;
    lock.lock();
    try {
      closed = true;
      changed.signalAll();
      if (socat != null) {
        socat.destroy();
      }
      keeper = thread;
    } finally {
      lock.unlock();
    }
    if (keeper == null) {
      return;
    }
    try {
      keeper.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void keep(Path program, int leadsTo, Path made) {
    try {
      while (mayGoOn()) {
        if (!emulator.cable().isPulled()) {
          join(program, leadsTo, made);
        }
        pause();
      }
    } catch (IOException e) {
      recordOutput(String.valueOf(e.getMessage()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      remove(made);
    }
  }

  private boolean mayGoOn() {
    lock.lock();
    try {
      return !closed;
    } finally {
      lock.unlock();
    }
  }

  /** Runs socat to its end. */
  private void join(Path program, int leadsTo, Path made) throws IOException, InterruptedException {
    Files.deleteIfExists(made);
    Process process =
        new ProcessBuilder(
                List.of(
                    program.toString(),
                    "-d",
                    "-d", // notices, and with them READY
                    "tcp:127.0.0.1:" + leadsTo,
                    "pty,raw,echo=0,link=" + made))
            .redirectErrorStream(true)
            .start();
    own(process);
    try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
      for (String line = output.readLine(); line != null; line = output.readLine()) {
        recordOutput(line);
      }
    } finally {
      own(null);
      process.destroy();
      if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        process.destroyForcibly().waitFor();
      }
    }
  }

  private void own(@Nullable Process process) {
    lock.lock();
    try {
      socat = process;
      if (closed && process != null) {
        process.destroy();
      }
    } finally {
      lock.unlock();
    }
  }

  private void recordOutput(String line) {
    lock.lock();
    try {
      ready |= line.contains(READY);
      fault = line;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  private void pause() throws InterruptedException {
    lock.lock();
    try {
      long left = TimeUnit.MILLISECONDS.toNanos(RETRY_MILLIS);
      while (!closed && left > 0) {
        left = changed.awaitNanos(left);
      }
    } finally {
      lock.unlock();
    }
  }

  private static void remove(Path made) {
    try {
      Files.deleteIfExists(made);
      Files.deleteIfExists(made.toAbsolutePath().getParent());
    } catch (IOException e) {
      // an empty temporary folder remains
    }
  }
}
