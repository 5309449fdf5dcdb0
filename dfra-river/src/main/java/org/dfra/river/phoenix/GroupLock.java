package org.dfra.river.phoenix;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * The lock that a process holds as long as it lives: a group's virtual machine, so that two of them
 * never own one group's devices together, and the daemon, so that two of them never write one
 * journal. The operating system takes it back when the process dies, however it dies.
 */
final class GroupLock implements AutoCloseable {

  /**
   * What this virtual machine holds. POSIX drops a process's lock when the process closes any
   * descriptor of the file, so a file that is held here must not even be opened again.
   */
  private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

  private final Path file;
  private final FileChannel channel;

  private GroupLock(Path file, FileChannel channel) {
    this.file = file;
    this.channel = channel;
  }

  /**
   * Takes the lock for this virtual machine.
   *
   * @param what it guards, for the message
   * @throws IOException if another one holds it, naming that one's process
   */
  static GroupLock take(Path file, String what) throws IOException {
    Path absolute = file.toAbsolutePath().normalize();
    if (!HELD.add(absolute)) {
      throw owned(Long.toString(ProcessHandle.current().pid()), what, file);
    }
    try {
      return new GroupLock(absolute, lock(file, what));
    } catch (IOException | RuntimeException e) {
      HELD.remove(absolute);
      throw e;
    }
  }

  private static FileChannel lock(Path file, String what) throws IOException {
    FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
    try {
      @Nullable FileLock lock = channel.tryLock();
      if (lock == null) {
        throw owned(Files.readString(file).trim(), what, file);
      }
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
      throw owned("of this virtual machine", what, file);
    }
  }

  private static IOException owned(String process, String what, Path file) {
    return new IOException(
        "process "
            + process
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
