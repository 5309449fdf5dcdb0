package org.dfra.river.phoenix.host;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import org.dfra.core.host.PrivateFiles;

/**
 * A private file of limited size. When it is full it becomes {@code file.1}, the former {@code
 * file.1} becomes {@code file.2}, and so on; the oldest is deleted.
 */
public final class RotatingFileOutputStream extends OutputStream {

  private final Path file;
  private final long limit;
  private final int kept;

  @GuardedBy("this")
  private OutputStream out;

  @GuardedBy("this")
  private long size;

  /**
   * @param file where to write; its present content is kept
   * @param limit bytes after which it is rotated
   * @param kept how many former files are kept
   */
  public RotatingFileOutputStream(Path file, long limit, int kept) throws IOException {
    this.file = file;
    this.limit = limit;
    this.kept = kept;
    this.out = open();
    this.size = Files.size(file);
  }

  @Override
  public synchronized void write(int b) throws IOException {
    write(new byte[] {(byte) b}, 0, 1);
  }

  @Override
  public synchronized void write(byte[] bytes, int offset, int length) throws IOException {
    if (size > 0 && size + length > limit) {
      rotate();
    }
    out.write(bytes, offset, length);
    size += length;
  }

  @GuardedBy("this")
  private void rotate() throws IOException {
    out.close();
    try {
      for (int i = kept; i > 1; i--) {
        Path from = numbered(i - 1);
        if (Files.exists(from)) {
          Files.move(from, numbered(i), StandardCopyOption.REPLACE_EXISTING);
        }
      }
      Files.move(file, numbered(1), StandardCopyOption.REPLACE_EXISTING);
    } finally {
      out = open(); // even after a failure, so that later output is not lost
      size = Files.size(file);
    }
  }

  private OutputStream open() throws IOException {
    PrivateFiles.makeFile(file);
    return Files.newOutputStream(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
  }

  private Path numbered(int number) {
    return file.resolveSibling(file.getFileName() + "." + number);
  }

  @Override
  public synchronized void flush() throws IOException {
    out.flush();
  }

  @Override
  public synchronized void close() throws IOException {
    out.close();
  }
}
