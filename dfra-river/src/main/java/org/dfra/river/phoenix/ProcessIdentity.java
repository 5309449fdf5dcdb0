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
import org.dfra.core.time.BootId;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A process, told apart from any later one that got the same number.
 *
 * <p>On Linux the start is counted in clock ticks since the boot, and the boot has a name: neither
 * moves when the wall clock is set, as it is on a robot whose receiver has just told it the time.
 * Elsewhere the start instant that the operating system reports has to do.
 *
 * <p>A process is dead when there is none of its number any more, or one that started at another
 * time. Where that cannot be found out, as in a shortage of file descriptors, it counts as alive: a
 * second process beside a living one would fight with it for a device.
 *
 * @param pid the process number
 * @param start when it started, in a form that only equality is asked of
 */
public record ProcessIdentity(long pid, String start) implements Serializable {

  private static final Logger LOG = LoggerFactory.getLogger(ProcessIdentity.class);

  /**
   * The identity of a process that lives.
   *
   * @throws UncheckedIOException if it cannot be found out; nobody can keep track of it then
   */
  static ProcessIdentity of(ProcessHandle handle) {
    Liveness sign = sign(handle.pid());
    if (sign instanceof Liveness.Unknown doubt) {
      throw new UncheckedIOException(
          "the start of process " + handle.pid() + " cannot be read: " + doubt.why().getMessage(),
          doubt.why());
    }
    return new ProcessIdentity(
        handle.pid(),
        sign instanceof Liveness.Alive lives
            ? lives.start()
            : "ended before its start could be read");
  }

  /**
   * The process that has a number now; empty where none has it.
   *
   * @throws IOException if that cannot be found out, as in a shortage of file descriptors
   */
  public static Optional<ProcessIdentity> find(long pid) throws IOException {
    Liveness sign = sign(pid);
    if (sign instanceof Liveness.Unknown doubt) {
      throw new IOException(
          "whether process "
              + pid
              + " runs cannot be found out ("
              + doubt.why().getMessage()
              + "); end what holds too many files open, and try again",
          doubt.why());
    }
    return sign instanceof Liveness.Alive lives
        ? Optional.of(new ProcessIdentity(pid, lives.start()))
        : Optional.empty();
  }

  /**
   * Whether this very process still runs, as far as is known: true also where that cannot be found
   * out now. A process that has ended but is unburied does not run.
   */
  public boolean isAlive() {
    Liveness sign = sign(pid);
    return sign instanceof Liveness.Alive lives
        ? lives.start().equals(start)
        : sign instanceof Liveness.Unknown;
  }

  /** Whether this very process certainly runs. */
  private boolean isCertainlyAlive() {
    return sign(pid) instanceof Liveness.Alive lives && lives.start().equals(start);
  }

  /**
   * Asks the process to end, or ends it; does nothing where it has ended. Where it is not known
   * whether its number is another process's by now, that is left alone, and said.
   */
  public void destroy(boolean forcibly) {
    boolean asked =
        isCertainlyAlive()
            && ProcessHandle.of(pid)
                .map(handle -> forcibly ? handle.destroyForcibly() : handle.destroy())
                .orElse(false);
    if (!asked && isAlive()) {
      LOG.warn("Process {} could not be ended now; are there too many open files?", pid);
    }
  }

  /**
   * Waits for the process to end.
   *
   * <p>The operating system tells a JVM of the end of its own children only, and these may be
   * another daemon's, so this looks every 20 ms.
   *
   * @return whether it has ended
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

  /** What is known of a process number. */
  private sealed interface Liveness {

    /** A process has it, which started then. */
    record Alive(String start) implements Liveness {}

    /** No process has it, or one that has ended and is unburied. */
    record Ended() implements Liveness {}

    /** It cannot be found out now. */
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
    // Not by ProcessHandle.of: it finds no process where this one may open no more files.
    Path stat = Path.of("/proc", Long.toString(pid), "stat");
    try {
      String line = Files.readString(stat, StandardCharsets.ISO_8859_1);
      // "pid (name) state …": the name may hold blanks and parentheses; field 3 is the state and
      // field 22 the start (proc(5)).
      String[] fields = line.substring(line.lastIndexOf(')') + 2).split(" ");
      boolean ended = fields[0].equals("Z") || fields[0].equals("X");
      return ended
          ? new Liveness.Ended()
          : new Liveness.Alive("tick " + fields[19] + " of boot " + boot());
    } catch (IOException e) {
      // Asking whether there is such a file opens none, so the answer is good in any shortage.
      return Files.notExists(stat) ? new Liveness.Ended() : new Liveness.Unknown(e);
    }
  }

  private static String boot() throws IOException {
    return BootId.system().read().orElseThrow(() -> new IOException("it names no boot any more"));
  }
}
