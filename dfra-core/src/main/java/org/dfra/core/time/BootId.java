package org.dfra.core.time;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Names the boot that monotonic time belongs to. On Linux {@link System#nanoTime} is the time since
 * the computer was started, the same in all of its virtual machines, so that one may hand it on to
 * another, or write it down for its next process, together with this.
 *
 * <p>The boot does not change while this process lives, so it is read once. A failure is never
 * remembered: a process that may open no more files reads it when it may again. Until then it is
 * not known, which is an exception and never another boot. Thread-safe.
 */
public final class BootId {

  private static final BootId SYSTEM = new BootId(Path.of("/proc/sys/kernel/random/boot_id"));

  private final Path file;
  private volatile @Nullable String known;

  /**
   * For tests: of another computer.
   *
   * @param file holds the ID; a file that does not exist is an operating system without one
   */
  public BootId(Path file) {
    this.file = file;
  }

  /** Of this computer. */
  public static BootId system() {
    return SYSTEM;
  }

  /** Whether the operating system names its boots. Asking opens no file. */
  public boolean isSupported() {
    return known != null || Files.isReadable(file);
  }

  /**
   * The ID; empty where the operating system names no boots.
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
