package org.dfra.authority.cli;

import java.nio.file.Path;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Where the authority is. A picocli mix-in. */
final class AuthorityFolderOption {

  @Option(
      names = "--authority",
      paramLabel = "FOLDER",
      description = "Folder of the authority (default: authority in the state folder).")
  private @Nullable Path folder;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  /** The authority's folder. */
  Path folder() {
    return folder == null ? state.folder().resolve("authority") : folder.toAbsolutePath();
  }

  /** The state folder. */
  Path state() {
    return state.folder();
  }
}
