package org.dfra.cli.module;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.dfra.cli.team.LastSeen;
import org.dfra.lifecycle.Readiness;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.Table;

/** Modules, one per line. */
public final class ModuleListPrinter {

  private ModuleListPrinter() {}

  /**
   * Prints modules.
   *
   * @param nothing the text if there are none
   */
  public static void show(CommandOutput answer, List<ModuleView> modules, String nothing) {
    Table table = new Table("MODULE", "KIND", "STATE", "CLIENTS", "HOST", "LAST SEEN");
    for (ModuleView each : modules) {
      table.row(
          each.path(),
          String.join(", ", each.kinds()),
          state(each)
              + (each.stopped() ? ", EMERGENCY STOP" : "")
              + (each.held().isPresent() ? ", HELD" : ""),
          Integer.toString(each.clients()),
          each.host(),
          LastSeen.of(each.stale(), each.confirmed()));
    }
    answer.table(modules, table, nothing);
    if (!answer.isJson()) {
      modules.stream()
          .flatMap(each -> Stream.concat(each.unusableReason().stream(), each.hold().stream()))
          .forEach(sentence -> answer.line(sentence, sentence));
    }
  }

  /** Its state, in a word or two. */
  static String state(ModuleView module) {
    return module.refused()
        ? "refused"
        : module.state().map(ModuleListPrinter::word).orElse("not known");
  }

  private static String word(Readiness state) {
    return state.name().toLowerCase(Locale.ROOT);
  }
}
