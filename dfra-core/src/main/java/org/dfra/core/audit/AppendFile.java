package org.dfra.core.audit;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.EnumSet;
import org.dfra.core.host.PrivateFiles;

/** A file to which the trail is appended. Tests use one that fails. */
interface AppendFile extends Closeable {

  /** Opens a file for writing at its end, and creates it privately if it is missing. */
  @FunctionalInterface
  interface Opener {
    AppendFile open(Path path) throws IOException;
  }

  /**
   * Appends bytes.
   *
   * @throws IOException if not all could be written; some may be in the file then
   */
  void append(byte[] bytes) throws IOException;

  /** Removes what follows a size. */
  void truncate(long size) throws IOException;

  /** Syncs the content to the disk. */
  void force() throws IOException;

  /** Opens a file of the file system. */
  static AppendFile open(Path path) throws IOException {
    FileChannel channel =
        FileChannel.open(
            path,
            EnumSet.of(
                StandardOpenOption.CREATE, StandardOpenOption.WRITE, StandardOpenOption.APPEND),
            PrivateFiles.privateFile());
    return new AppendFile() {
      @Override
      public void append(byte[] bytes) throws IOException {
        ByteBuffer left = ByteBuffer.wrap(bytes);
        while (left.hasRemaining()) {
          int unused = channel.write(left);
        }
      }

      @Override
      public void truncate(long size) throws IOException {
        FileChannel unused = channel.truncate(size);
      }

      @Override
      public void force() throws IOException {
        channel.force(true);
      }

      @Override
      public void close() throws IOException {
        channel.close();
      }
    };
  }
}
