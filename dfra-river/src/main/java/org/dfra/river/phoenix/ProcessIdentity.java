package org.dfra.river.phoenix;

import java.io.IOException;
import java.io.Serializable;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * A process, told apart from any later one that got the same number.
 *
 * <p>On Linux the start is counted in clock ticks since the boot, and the boot has a name: neither
 * moves when the wall clock is set, as it is on a robot whose receiver has just told it the time.
 * Elsewhere the start instant that the operating system reports has to do.
 *
 * @param pid the process number
 * @param start when it started, in a form that only equality is asked of
 */
record ProcessIdentity(long pid, String start) implements Serializable {

  private static final Path BOOT_ID = Path.of("/proc/sys/kernel/random/boot_id");

  /** The identity of a process that lives. */
  static ProcessIdentity of(ProcessHandle handle) {
    return new ProcessIdentity(
        handle.pid(), start(handle).orElse("ended before its start could be read"));
  }

  /** Whether this very process still runs. A process that has ended but is unburied does not. */
  boolean isAlive() {
    return ProcessHandle.of(pid).flatMap(ProcessIdentity::start).map(start::equals).orElse(false);
  }

  /** Asks the process to end, or ends it; does nothing where it has ended. */
  void destroy(boolean forcibly) {
    if (isAlive()) {
      ProcessHandle.of(pid)
          .ifPresent(
              handle -> {
                boolean asked = forcibly ? handle.destroyForcibly() : handle.destroy();
                assert asked || !isAlive();
              });
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
  boolean awaitDeath(Duration patience) {
    long end = System.nanoTime() + patience.toNanos();
    while (isAlive()) {
      if (System.nanoTime() - end > 0 || Thread.currentThread().isInterrupted()) {
        return false;
      }
      LockSupport.parkNanos(this, TimeUnit.MILLISECONDS.toNanos(20));
    }
    return true;
  }

  private static Optional<String> start(ProcessHandle handle) {
    Path stat = Path.of("/proc", Long.toString(handle.pid()), "stat");
    if (!Files.isReadable(BOOT_ID)) {
      return handle.isAlive()
          ? handle.info().startInstant().map(instant -> "at " + instant.toEpochMilli())
          : Optional.empty();
    }
    try {
      String line = Files.readString(stat, StandardCharsets.ISO_8859_1);
      // "pid (name) state …": the name may hold blanks and parentheses; field 3 is the state and
      // field 22 the start (proc(5)).
      String[] fields = line.substring(line.lastIndexOf(')') + 2).split(" ");
      boolean ended = fields[0].equals("Z") || fields[0].equals("X");
      return ended
          ? Optional.empty()
          : Optional.of("tick " + fields[19] + " of boot " + Files.readString(BOOT_ID).trim());
    } catch (IOException e) {
      return Optional.empty(); // it ended meanwhile
    }
  }
}
