package org.dfra.core.time;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Identifies the boot that monotonic time belongs to. On Linux {@link System#nanoTime} is the time
 * since boot, the same in all virtual machines of the computer. So one virtual machine may pass it
 * to another, or store it for its next process, together with this ID.
 *
 * <p>The boot does not change while this process lives, so it is read once. A failure is not
 * cached: a process without free file descriptors reads it later. Until then reading throws, and
 * never returns another boot's ID. Thread-safe.
 */
public final class BootId {

  private static final BootId SYSTEM = new BootId(Path.of("/proc/sys/kernel/random/boot_id"));

  private final Path file;
  private volatile @Nullable String known;

  /**
   * For tests: the ID of another computer.
   *
   * @param file contains the ID; a missing file means an operating system without one
   */
  public BootId(Path file) {
    this.file = file;
  }

  /** The ID of this computer. */
  public static BootId system() {
    return SYSTEM;
  }

  /** Whether the operating system identifies its boots. Opens no file. */
  public boolean isSupported() {
    return known != null || Files.isReadable(file);
  }

  /**
   * The ID; empty if the operating system does not identify boots.
   *
   * @throws IOException if it cannot be read now, as in a shortage of file descriptors
   */
  public Optional<String> read() throws IOException {
    @Nullable String id = known;
    if (id == null) {
      if (!isSupported()) {
        return Optional.empty();
      }
      id = Files.readString(file).strip();
      if (id.isEmpty()) {
        throw new IOException(file + " is empty");
      }
      known = id;
    }
    return Optional.of(id);
  }
}
