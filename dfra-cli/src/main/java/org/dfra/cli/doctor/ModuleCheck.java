package org.dfra.cli.doctor;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.cli.team.UnreadyModule;
import org.dfra.core.host.CommandName;
import org.dfra.lifecycle.Readiness;
import org.dfra.river.lookup.JiniModuleDirectory.ModuleConflict;
import org.dfra.river.lookup.JiniModuleDirectory.UnreadableModule;

/**
 * Checks which modules cannot be used: they are not ready, or their classes are refused here. Also
 * finds modules that several lookup services list differently.
 */
final class ModuleCheck implements Check {

  /**
   * The modules that cannot be used.
   *
   * @param unready those that are not ready
   * @param unreadable those whose proxies cannot be deserialized here
   * @param conflicts those that several lookup services list differently
   */
  record UnusableModules(
      List<UnreadyModule> unready,
      List<UnreadableModule> unreadable,
      List<ModuleConflict> conflicts) {}

  /** Finds them. */
  interface ModuleProbe {
    UnusableModules unusable() throws InterruptedException;
  }

  private final ModuleProbe modules;

  ModuleCheck(ModuleProbe modules) {
    this.modules = modules;
  }

  @Override
  public Subject subject() {
    return Subject.MODULE;
  }

  @Override
  public List<Finding> run() throws InterruptedException {
    UnusableModules unusable = modules.unusable();
    List<Finding> findings = new ArrayList<>();
    for (UnreadyModule each : unusable.unready()) {
      if (each.state() != Readiness.PAUSED) { // stopped on purpose
        findings.add(of(each));
      }
    }
    for (UnreadableModule each : unusable.unreadable()) {
      findings.add(
          Finding.warn(
              subject(),
              each.path() + " cannot be used here: " + Reason.what(each.reason()),
              Reason.remedy(
                  each.reason(),
                  "Trust its robot's classes; docs/reference/trusted-code.md says how.")));
    }
    for (ModuleConflict each : unusable.conflicts()) {
      String reason = each.describe();
      findings.add(Finding.warn(subject(), Reason.what(reason), Reason.remedy(reason, "")));
    }
    return findings;
  }

  private Finding of(UnreadyModule module) {
    String what =
        module.path()
            + " is "
            + module.state().name().toLowerCase(Locale.ROOT)
            + ": "
            + Reason.what(module.reason());
    String remedy =
        Reason.remedy(
            module.reason(),
            "Look at its device and its link; "
                + CommandName.current()
                + " module info "
                + module.path()
                + " shows its parameters and its history.");
    return module.state() == Readiness.FAILED
        ? Finding.fail(subject(), what, remedy)
        : Finding.warn(subject(), what, remedy);
  }

  /** A sentence that may contain a remedy after a semicolon. */
  private static final class Reason {

    static String what(String reason) {
      int semicolon = reason.lastIndexOf("; ");
      return semicolon < 0 ? reason : reason.substring(0, semicolon);
    }

    static String remedy(String reason, String otherwise) {
      int semicolon = reason.lastIndexOf("; ");
      return semicolon < 0
          ? otherwise
          : Character.toUpperCase(reason.charAt(semicolon + 2))
              + reason.substring(semicolon + 3)
              + (reason.endsWith("?") ? "" : ".");
    }
  }
}
