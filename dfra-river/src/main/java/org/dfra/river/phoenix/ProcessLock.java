package org.dfra.river.phoenix;

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
 * The lock that a process holds as long as it lives: a group's virtual machine, so that two of them
 * never own one group's devices together, and the daemon, so that two of them never write one
 * journal. The operating system takes it back when the process dies, however it dies.
 *
 * <p>The file is private: whoever may open a file may lock it, also for reading only, and so keep a
 * group from starting again.
 */
final class ProcessLock implements AutoCloseable {

  /**
   * What this virtual machine holds. POSIX drops a process's lock when the process closes any
   * descriptor of the file, so a file that is held here must not even be opened again.
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
   * Takes the lock for this virtual machine.
   *
   * @param guarded it guards, for the message
   * @throws IOException if another one holds it, naming that one's process and user
   */
  static ProcessLock acquire(Path file, String guarded) throws IOException {
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

  /** Gives the lock back. */
  @Override
  public void close() throws IOException {
    channel.close();
    HELD.remove(file);
  }
}
