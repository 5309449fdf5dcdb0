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
 * State in files. Documents are written beside their name, brought to the disk and renamed.
 * Counters are mapped into memory, eight bytes each at a multiple of eight: the kernel keeps what
 * was stored when the process dies.
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
      directory.force(true); // the new name itself
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
   * Writes what the file holds once, so that the disk has room for all of it. Where it has not,
   * that is an exception here. With a hole in the file it would be an {@link InternalError}, at any
   * time after the first store into the hole, in whatever the thread does then.
   */
  private static void allocate(FileChannel channel, int size) throws IOException {
    ByteBuffer content = ByteBuffer.allocate(size);
    while (content.hasRemaining() && channel.read(content, content.position()) > 0) {
      // a short read goes on
    }
    content.clear(); // what was not there is zero
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
