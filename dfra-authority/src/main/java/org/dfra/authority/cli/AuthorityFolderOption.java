package org.dfra.authority.cli;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Where the authority is. A picocli mix-in. */
final class AuthorityFolderOption {

  @Option(
      names = "--authority",
      paramLabel = "FOLDER",
      description = "Folder of the authority (default: authority in the state folder).")
  private @Nullable Path folder;

  /** The authority's folder, for a state folder. */
  Path in(Path state) {
    return folder == null ? state.resolve("authority") : folder.toAbsolutePath();
  }
}
