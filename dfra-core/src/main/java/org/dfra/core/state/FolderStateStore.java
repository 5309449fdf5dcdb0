package org.dfra.core.state;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.dfra.core.host.PrivateFiles;

/**
 * State in files. Documents are written to a temporary file, synced to disk and renamed. Counters
 * are memory-mapped, eight bytes each, aligned to eight: the kernel keeps the stored values when
 * the process dies.
 */
final class FolderStateStore implements StateStore {

  private final Path folder;

  FolderStateStore(Path folder) {
    this.folder = folder;
  }

  @Override
  public Optional<byte[]> read(String name) throws IOException {
    try {
      return Optional.of(Files.readAllBytes(folder.resolve(name)));
    } catch (NoSuchFileException e) {
      return Optional.empty();
    }
  }

  @Override
  public synchronized void write(String name, byte[] content) throws IOException {
    PrivateFiles.makeFolder(folder);
    Path whole = folder.resolve(name);
    Path beside = folder.resolve(name + ".new");
    try (FileChannel channel =
        FileChannel.open(
            beside,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE)) {
      ByteBuffer left = ByteBuffer.wrap(content);
      while (left.hasRemaining()) {
        int unused = channel.write(left);
      }
      channel.force(true);
    }
    Path unused =
        Files.move(
            beside, whole, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    try (FileChannel directory = FileChannel.open(folder, StandardOpenOption.READ)) {
      directory.force(true); // syncs the new name itself
    }
  }

  @Override
  public Counters counters(String name, int count) throws IOException {
    PrivateFiles.makeFolder(folder);
    try (FileChannel channel =
        FileChannel.open(
            folder.resolve(name),
            StandardOpenOption.CREATE,
            StandardOpenOption.READ,
            StandardOpenOption.WRITE)) {
      int size = count * Long.BYTES;
      allocate(channel, size);
      return new Mapped(channel.map(FileChannel.MapMode.READ_WRITE, 0, size));
    }
  }

  /**
   * Writes the file's content once, to allocate its disk space. If the disk is full, this throws an
   * exception here. With a hole in the file, a full disk would cause an {@link InternalError} at
   * any time after the first store into the hole, in unrelated code.
   */
  private static void allocate(FileChannel channel, int size) throws IOException {
    ByteBuffer content = ByteBuffer.allocate(size);
    while (content.hasRemaining() && channel.read(content, content.position()) > 0) {
      // continue after a short read
    }
    content.clear(); // missing bytes are zero
    while (content.hasRemaining()) {
      int unused = channel.write(content, content.position());
    }
  }

  private record Mapped(MappedByteBuffer buffer) implements Counters {

    @Override
    public long get(int index) {
      return buffer.getLong(index * Long.BYTES);
    }

    @Override
    public void set(int index, long value) {
      buffer.putLong(index * Long.BYTES, value);
    }

    @Override
    public void force() {
      buffer.force();
    }
  }

  @Override
  public String toString() {
    return folder.toString();
  }
}
