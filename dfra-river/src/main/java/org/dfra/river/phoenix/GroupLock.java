package org.dfra.river.phoenix;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.jspecify.annotations.Nullable;

/**
 * The lock that a group's virtual machine holds as long as it lives, so that two of them never own
 * one group's devices together. The operating system takes it back when the machine dies, however
 * it dies.
 */
final class GroupLock implements AutoCloseable {

  private final FileChannel channel;

  private GroupLock(FileChannel channel) {
    this.channel = channel;
  }

  /**
   * Takes the lock for this virtual machine.
   *
   * @throws IOException if another one holds it, naming that one's process
   */
  static GroupLock take(Path file) throws IOException {
    FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
    try {
      @Nullable FileLock lock = channel.tryLock();
      if (lock == null) {
        throw new IOException(
            "process "
                + Files.readString(file).trim()
                + " still owns this group (it holds "
                + file
                + "); a second one is refused until that one has ended");
      }
      channel.truncate(0);
      channel.write(
          ByteBuffer.wrap(
              Long.toString(ProcessHandle.current().pid()).getBytes(StandardCharsets.US_ASCII)));
      return new GroupLock(channel);
    } catch (IOException e) {
      channel.close();
      throw e;
    }
  }

  /** Gives the lock back. */
  @Override
  public void close() throws IOException {
    channel.close();
  }
}
