package org.dfra.core.audit;

import java.io.Closeable;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.EnumSet;
import org.dfra.core.host.PrivateFiles;

/**
 * Keeps other processes from writing the same stream. The kernel frees it when its process dies.
 */
final class StreamLock implements Closeable {

  private final FileChannel channel;

  private StreamLock(FileChannel channel) {
    this.channel = channel;
  }

  /**
   * Locks a stream.
   *
   * @throws IOException if it is locked already
   */
  static StreamLock lock(Path folder, String stream) throws IOException {
    Path file = folder.resolve(stream + ".lock");
    FileChannel channel =
        FileChannel.open(
            file,
            EnumSet.of(StandardOpenOption.CREATE, StandardOpenOption.WRITE),
            PrivateFiles.privateFile());
    if (isLocked(channel)) {
      return new StreamLock(channel);
    }
    channel.close();
    throw new IOException(
        "another process, or another part of this one, writes the audit trail "
            + stream
            + " in "
            + folder
            + "; give each a stream of its own");
  }

  private static boolean isLocked(FileChannel channel) throws IOException {
    try {
      return channel.tryLock() != null;
    } catch (OverlappingFileLockException e) {
      return false; // by this process
    } catch (IOException e) {
      channel.close();
      throw e;
    }
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
