package org.dfra.river.phoenix.host;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.core.host.PrivateFiles;
import org.jspecify.annotations.Nullable;

/**
 * A lock that a process holds until it exits. A group's virtual machine holds one, so that no two
 * use the same devices. The daemon holds one, so that no two write the same journal. The operating
 * system releases it when the process exits for any reason.
 *
 * <p>The file is private: a process that may open it, even only for reading, may lock it and
 * prevent the group's restart.
 */
public final class ProcessLock implements AutoCloseable {

  /**
   * Files that this virtual machine has locked. POSIX drops a process's lock when the process
   * closes any descriptor of the file, so it must not open a locked file again.
   */
  private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

  private static final Set<StandardOpenOption> OPEN =
      Set.of(StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);

  private static final LockHolderFinder HOLDER = new LockHolderFinder(Path.of("/proc"));

  private final Path file;
  private final FileChannel channel;

  private ProcessLock(Path file, FileChannel channel) {
    this.file = file;
    this.channel = channel;
  }

  /**
   * Acquires the lock for this virtual machine.
   *
   * @param guarded what the lock guards, for the message
   * @throws IOException if another process holds it; the message names that process and its user
   */
  public static ProcessLock acquire(Path file, String guarded) throws IOException {
    Path absolute = file.toAbsolutePath().normalize();
    if (!HELD.add(absolute)) {
      throw owned(HOLDER.inWords(ProcessHandle.current().pid()), guarded, file);
    }
    try {
      return new ProcessLock(absolute, lock(file, guarded));
    } catch (IOException | RuntimeException e) {
      HELD.remove(absolute);
      throw e;
    }
  }

  private static FileChannel lock(Path file, String what) throws IOException {
    FileChannel channel = FileChannel.open(file, OPEN, PrivateFiles.privateFile());
    try {
      @Nullable FileLock lock = channel.tryLock();
      if (lock == null) {
        throw owned(HOLDER.of(file), what, file);
      }
      PrivateFiles.closeToOthers(file); // a former version made it readable
      channel.truncate(0);
      channel.write(
          ByteBuffer.wrap(
              Long.toString(ProcessHandle.current().pid()).getBytes(StandardCharsets.US_ASCII)));
      return channel;
    } catch (IOException e) {
      channel.close();
      throw e;
    } catch (OverlappingFileLockException e) {
      channel.close();
      throw owned(HOLDER.inWords(ProcessHandle.current().pid()), what, file);
    }
  }

  private static IOException owned(String holder, String what, Path file) {
    return new IOException(
        holder
            + " still owns "
            + what
            + " (it holds "
            + file
            + "); a second one is refused until that one has ended");
  }

  /** Releases the lock. */
  @Override
  public void close() throws IOException {
    channel.close();
    HELD.remove(file);
  }
}
