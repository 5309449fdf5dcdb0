package org.dfra.app.module;

import java.util.List;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.core.config.NearestName;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Diagnosable;
import org.dfra.module.Module;

/** Modules that can be examined. */
final class Diagnosables {

  private Diagnosables() {}

  /**
   * The module as one that can be examined.
   *
   * @throws CommandFailure if it cannot
   */
  static Diagnosable of(ModuleListing<Module> listing) {
    if (listing.module() instanceof Diagnosable diagnosable) {
      return diagnosable;
    }
    throw new CommandFailure(
        ExitCode.FAILED,
        listing.path() + " can be neither tested nor recovered; only sensors and effectors can");
  }

  /**
   * A name that the module knows.
   *
   * @param what what is named, {@code test} or {@code recovery}
   * @throws CommandFailure if it does not
   */
  static String known(String module, String what, List<String> names, String wanted) {
    if (names.contains(wanted)) {
      return wanted;
    }
    throw new CommandFailure(
        ExitCode.NOT_FOUND,
        module
            + " has no "
            + what
            + " "
            + wanted
            + NearestName.hint(
                wanted,
                names,
                names.isEmpty() ? "; it has none" : "; it has " + String.join(", ", names)));
  }
}
