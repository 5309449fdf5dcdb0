package org.dfra.core.time;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/**
 * Which boot of which computer the monotonic time belongs to. On Linux {@link System#nanoTime} is
 * the time since the computer was started, the same in all of its virtual machines, so that one may
 * hand it on to another, together with this.
 *
 * @param id names the boot; null where that is not known, so that nothing may be handed on
 */
record BootClock(@Nullable String id) {

  private static final Path BOOT_ID = Path.of("/proc/sys/kernel/random/boot_id");
  private static final BootClock SYSTEM = read();

  /** Of this computer. */
  static BootClock system() {
    return SYSTEM;
  }

  private static BootClock read() {
    try {
      String id = Files.readString(BOOT_ID).strip();
      return new BootClock(id.isEmpty() ? null : id);
    } catch (IOException e) {
      return new BootClock(null); // not Linux
    }
  }
}
