package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Locks on files, held until this process ends. A shared lock needs only read permission, and keeps
 * other processes from an exclusive lock. Not thread-safe.
 */
public final class FileLocks {

  private final Map<Path, FileLock> held = new LinkedHashMap<>();

  /** Holds no lock yet. */
  public FileLocks() {}

  /**
   * Acquires the lock of a file, unless it is held already.
   *
   * @return false if another process holds it
   * @throws IOException if the file cannot be read
   */
  public boolean take(Path file) throws IOException {
    if (held.containsKey(file)) {
      return true;
    }
    FileChannel channel = FileChannel.open(file, StandardOpenOption.READ);
    try {
      @Nullable FileLock lock = channel.tryLock(0, Long.MAX_VALUE, true);
      if (lock != null) {
        held.put(file, lock);
      }
      return lock != null;
    } finally {
      if (!held.containsKey(file)) {
        channel.close();
      }
    }
  }

  /** Number of locks held. */
  public int count() {
    return held.size();
  }
}
