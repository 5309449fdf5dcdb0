package org.dfra.river.loading;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.dfra.core.host.PrivateFiles;
import org.jspecify.annotations.Nullable;

/**
 * Stores the jars of a robot's codebase annotations, each under its digest, in a folder that
 * outlives the groups. So clients can still fetch the jars of older annotations after a rebuild, in
 * whichever order the groups restart. Several processes use it at the same time.
 */
final class JarStore {

  /** Enough for every group of a robot and some rebuilds; the oldest are deleted first. */
  static final int MAX_JARS = 64;

  private final Path folder;

  JarStore(Path folder) {
    this.folder = folder;
  }

  /**
   * Stores a jar as the newest.
   *
   * @throws IOException if the folder cannot be written
   */
  void put(byte[] bytes, String digest) throws IOException {
    Path file = file(digest);
    try {
      PrivateFiles.makeFolder(folder);
      if (!Files.exists(file)) {
        Path partial = Files.createTempFile(folder, "new", ".part");
        Files.write(partial, bytes);
        Files.move(partial, file, StandardCopyOption.ATOMIC_MOVE);
      }
      Files.setLastModifiedTime(file, FileTime.from(Instant.now()));
      forgetOldest();
    } catch (IOException e) {
      throw new IOException(
          "the folder " + folder + " cannot keep a jar (" + e + "); make it writable", e);
    }
  }

  /**
   * A jar by its digest; null if it is not stored, or the file is damaged.
   *
   * @throws IOException if it cannot be read
   */
  byte @Nullable [] find(String digest) throws IOException {
    try {
      byte[] bytes = Files.readAllBytes(file(digest));
      return Digests.sha256(bytes).equals(digest) ? bytes : null;
    } catch (NoSuchFileException e) {
      return null;
    }
  }

  private Path file(String digest) {
    return folder.resolve(digest + ".jar");
  }

  private void forgetOldest() throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.list(folder)) {
      files = all.filter(file -> file.toString().endsWith(".jar")).toList();
    }
    if (files.size() > MAX_JARS) {
      List<Path> oldest =
          files.stream()
              .sorted(Comparator.comparingLong(file -> file.toFile().lastModified()))
              .limit(files.size() - MAX_JARS)
              .toList();
      for (Path file : oldest) {
        Files.deleteIfExists(file); // another process may do the same
      }
    }
  }
}
