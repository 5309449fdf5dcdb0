package org.dfra.cli.security;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.stream.Stream;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.identity.IdentityFolder;

/**
 * The replacement of an identity's folder by another one. A folder cannot replace another that is
 * not empty in one step, so the former one steps aside first ({@link IdentityFolder#replaced}).
 */
final class FolderReplacement {

  private final Path folder;
  private final Path former;

  FolderReplacement(Path folder) {
    this.folder = folder;
    former = IdentityFolder.replaced(folder);
  }

  /** Puts a folder that is written completely in place. */
  void replaceWith(Path draft) throws IOException {
    if (Files.exists(folder)) {
      Path unused = Files.move(folder, former, StandardCopyOption.ATOMIC_MOVE);
    }
    Path unused = Files.move(draft, folder, StandardCopyOption.ATOMIC_MOVE);
    PrivateFiles.sync(folder.resolveSibling("."));
    delete(former);
  }

  /** Undoes what a replacement that was interrupted has left. */
  void undoInterrupted() throws IOException {
    if (!Files.exists(former)) {
      return;
    }
    if (Files.exists(folder)) {
      delete(former);
    } else {
      Path unused = Files.move(former, folder, StandardCopyOption.ATOMIC_MOVE);
    }
  }

  /** Deletes a folder of files; does nothing if there is none. */
  static void delete(Path folder) throws IOException {
    if (!Files.exists(folder)) {
      return;
    }
    try (Stream<Path> files = Files.list(folder)) {
      for (Path each : files.toList()) {
        Files.delete(each);
      }
    }
    Files.delete(folder);
  }
}
