package org.dfra.core.audit;

import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.dfra.core.host.PrivateFiles;
import org.jspecify.annotations.Nullable;

/** Reads a file line by line, with at most one line in memory. */
final class LineReader implements Closeable {

  /** No line of a trail is longer, bytes. */
  static final int LONGEST_LINE = 32 * 1024;

  /**
   * A line.
   *
   * @param bytes without its end; only the beginning if it is too long
   * @param isComplete whether it has an end
   * @param isTooLong whether it has more than {@value LineReader#LONGEST_LINE} bytes
   * @param end offset of the next line in the file
   */
  record RawLine(byte[] bytes, boolean isComplete, boolean isTooLong, long end) {}

  private final InputStream in;

  /** Of our own: a buffered stream takes a lock for each byte. */
  private final byte[] buffer = new byte[LONGEST_LINE];

  private int at;
  private int limit;
  private long offset;

  /** Of a stream that is at an offset of what is read. */
  LineReader(InputStream in, long offset) {
    this.in = in;
    this.offset = offset;
  }

  /** Opens a file at an offset, where a line begins. */
  static LineReader open(Path path, long offset) throws IOException {
    FileChannel channel;
    try {
      channel = FileChannel.open(path, StandardOpenOption.READ);
    } catch (AccessDeniedException e) {
      throw notReadable(path, e);
    }
    InputStream in = Channels.newInputStream(channel.position(offset)); // may be after the end
    return new LineReader(in, offset);
  }

  /** What to do if a user may not read a file or a folder. */
  static IOException notReadable(Path path, AccessDeniedException e) {
    String owner = PrivateFiles.ownerName(path);
    return new IOException("cannot read " + path + "; run this as user " + owner, e);
  }

  /** The next line; null at the end of the file. */
  @Nullable RawLine next() throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream(512);
    boolean isTooLong = false;
    int read = read();
    if (read < 0) {
      return null;
    }
    while (read >= 0) {
      offset++;
      if (read == '\n') {
        return new RawLine(line.toByteArray(), true, isTooLong, offset);
      }
      if (line.size() < LONGEST_LINE) {
        line.write(read);
      } else {
        isTooLong = true;
      }
      read = read();
    }
    return new RawLine(line.toByteArray(), false, isTooLong, offset);
  }

  private int read() throws IOException {
    if (at == limit) {
      at = 0;
      limit = Math.max(0, in.read(buffer));
      if (limit == 0) {
        return -1;
      }
    }
    return buffer[at++] & 0xff;
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
