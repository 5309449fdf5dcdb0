package org.dfra.authority.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import org.dfra.authority.Authority;
import org.dfra.cli.security.PassphraseSource;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Where the authority is, and how it is opened. A picocli mix-in. */
final class AuthorityOptions {

  private static final String PASSPHRASE_FILE = "--authority-passphrase-file";

  @Option(
      names = PASSPHRASE_FILE,
      paramLabel = "FILE",
      description =
          "File whose first line is the authority's passphrase (default: stored, or asks for it).")
  private @Nullable Path passphraseFile;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private AuthorityFolderOption place;

  /** The authority's folder, for a state folder. */
  Path folder(Path state) {
    return place.in(state);
  }

  /** Opens it. */
  Authority open(Path state) throws IOException {
    return Authority.open(
        folder(state),
        () -> PassphraseSource.read(passphraseFile, "passphrase of the authority", PASSPHRASE_FILE),
        Clock.systemUTC());
  }
}
