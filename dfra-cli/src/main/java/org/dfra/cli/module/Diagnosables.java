package org.dfra.cli.module;

import java.util.List;
import org.dfra.core.config.NearestName;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Diagnosable;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;

/** Modules with diagnostics. */
final class Diagnosables {

  private Diagnosables() {}

  /**
   * The module as a diagnosable one.
   *
   * @throws CommandFailure if it is not
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
   * Checks a name against the module's.
   *
   * @param what kind of name, {@code test} or {@code recovery}
   * @throws CommandFailure if the module does not have it
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
