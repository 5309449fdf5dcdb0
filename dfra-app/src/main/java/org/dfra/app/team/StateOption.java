package org.dfra.app.team;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The option for phoenix's state folder on this host. A picocli mix-in. */
public final class StateOption {

  @Option(
      names = "--state",
      paramLabel = "FOLDER",
      description = "Where phoenix keeps its journal and logs (default: DFRA_STATE, or ~/.dfra).")
  private @Nullable Path state;

  /** The folder, as an absolute path. It may not exist yet. */
  public Path folder() {
    if (state != null) {
      return state.toAbsolutePath();
    }
    String variable = System.getenv("DFRA_STATE");
    return variable == null || variable.isBlank()
        ? Path.of(home(), ".dfra").toAbsolutePath()
        : Path.of(variable).toAbsolutePath();
  }

  /** The shell's meaning of ~; Java's user.home may be another folder. */
  private static String home() {
    String home = System.getenv("HOME");
    return home == null || home.isBlank() ? System.getProperty("user.home") : home;
  }
}
