package org.dfra.river.phoenix;

import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Predicate;
import org.dfra.core.time.BootId;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A process, distinct from any later one with the same number.
 *
 * <p>On Linux the start is counted in clock ticks since the boot, and the boot has an ID. Neither
 * changes when the wall clock is set, as a GPS receiver does on a robot. Elsewhere, the start is
 * the instant that the operating system reports.
 *
 * <p>A process has exited if no process has its number any more, or one with another start time
 * has. If this cannot be determined, as in a shortage of file descriptors, the process counts as
 * running: a second process beside it would compete for its device.
 *
 * @param pid the process number
 * @param start when it started, compared for equality only
 */
public record ProcessIdentity(long pid, String start) implements Serializable {

  private static final Logger LOG = LoggerFactory.getLogger(ProcessIdentity.class);

  /**
   * The identity of a running process.
   *
   * @throws UncheckedIOException if it cannot be determined; then the process cannot be tracked
   */
  static ProcessIdentity of(ProcessHandle handle) {
    Liveness sign = sign(handle.pid());
    if (sign instanceof Liveness.Unknown unknown) {
      throw new UncheckedIOException(
          "the start of process " + handle.pid() + " cannot be read: " + unknown.why().getMessage(),
          unknown.why());
    }
    return new ProcessIdentity(
        handle.pid(),
        sign instanceof Liveness.Alive lives
            ? lives.start()
            : "ended before its start could be read");
  }

  /**
   * The process that has a number now; empty if there is none.
   *
   * @throws IOException if this cannot be determined, as in a shortage of file descriptors
   */
  public static Optional<ProcessIdentity> find(long pid) throws IOException {
    Liveness sign = sign(pid);
    if (sign instanceof Liveness.Unknown unknown) {
      throw new IOException(
          "whether process "
              + pid
              + " runs cannot be determined ("
              + unknown.why().getMessage()
              + "); stop the program that holds too many files open, and try again",
          unknown.why());
    }
    return sign instanceof Liveness.Alive lives
        ? Optional.of(new ProcessIdentity(pid, lives.start()))
        : Optional.empty();
  }

  /**
   * Whether this process still runs, as far as is known: true also if this cannot be determined
   * now. A zombie does not run.
   */
  public boolean isAlive() {
    Liveness sign = sign(pid);
    return sign instanceof Liveness.Alive lives
        ? lives.start().equals(start)
        : sign instanceof Liveness.Unknown;
  }

  /** Whether this process certainly runs. */
  private boolean isCertainlyAlive() {
    return sign(pid) instanceof Liveness.Alive lives && lives.start().equals(start);
  }

  /**
   * Requests the process to exit; does nothing if it has exited. If its number may belong to
   * another process by now, this only logs that.
   */
  public void terminate() {
    end(ProcessHandle::destroy);
  }

  /** Kills the process, under the same conditions as {@link #terminate}. */
  public void kill() {
    end(ProcessHandle::destroyForcibly);
  }

  private void end(Predicate<ProcessHandle> way) {
    boolean asked = isCertainlyAlive() && ProcessHandle.of(pid).filter(way).isPresent();
    if (!asked && isAlive()) {
      LOG.warn("Process {} could not be ended; check whether too many files are open.", pid);
    }
  }

  /**
   * Waits for the process to exit.
   *
   * <p>The operating system notifies a JVM only of the exit of its own children. These may be
   * another daemon's, so this polls every 20 ms.
   *
   * @return whether it has exited
   */
  boolean awaitExit(Duration timeout) {
    long end = System.nanoTime() + timeout.toNanos();
    while (isAlive()) {
      if (System.nanoTime() - end > 0 || Thread.currentThread().isInterrupted()) {
        return false;
      }
      LockSupport.parkNanos(this, TimeUnit.MILLISECONDS.toNanos(20));
    }
    return true;
  }

  /** The state of a process number. */
  private sealed interface Liveness {

    /** A process that started then has it. */
    record Alive(String start) implements Liveness {}

    /** No process has it, or a zombie. */
    record Ended() implements Liveness {}

    /** It cannot be determined now. */
    record Unknown(IOException why) implements Liveness {}
  }

  private static Liveness sign(long pid) {
    if (!BootId.system().isSupported()) {
      return ProcessHandle.of(pid)
          .filter(ProcessHandle::isAlive)
          .flatMap(handle -> handle.info().startInstant())
          .<Liveness>map(instant -> new Liveness.Alive("at " + instant.toEpochMilli()))
          .orElseGet(Liveness.Ended::new);
    }
    // ProcessHandle.of does not work: it finds no process if this one may open no more files.
    Path stat = Path.of("/proc", Long.toString(pid), "stat");
    try {
      String line = Files.readString(stat, StandardCharsets.ISO_8859_1);
      // "pid (name) state …": the name may contain blanks and parentheses; field 3 is the state and
      // field 22 the start (proc(5)).
      String[] fields = line.substring(line.lastIndexOf(')') + 2).split(" ");
      boolean ended = fields[0].equals("Z") || fields[0].equals("X");
      return ended
          ? new Liveness.Ended()
          : new Liveness.Alive("tick " + fields[19] + " of boot " + boot());
    } catch (IOException e) {
      // This check opens no file, so the answer is reliable in any shortage.
      return Files.notExists(stat) ? new Liveness.Ended() : new Liveness.Unknown(e);
    }
  }

  private static String boot() throws IOException {
    return BootId.system()
        .read()
        .orElseThrow(() -> new IOException("the boot ID cannot be read any more"));
  }
}
