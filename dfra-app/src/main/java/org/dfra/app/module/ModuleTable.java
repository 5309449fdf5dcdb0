package org.dfra.app.module;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import org.dfra.app.terminal.Answer;
import org.dfra.app.terminal.Table;
import org.dfra.module.Readiness;

/** Modules, a line each. */
public final class ModuleTable {

  private ModuleTable() {}

  /**
   * Answers with modules.
   *
   * @param nothing what people are told when there are none
   */
  public static void show(Answer answer, List<ModuleView> modules, String nothing) {
    Table table = new Table("MODULE", "KIND", "STATE", "CLIENTS", "HOST", "SEEN");
    Instant now = Instant.now();
    for (ModuleView each : modules) {
      table.row(
          each.path(),
          String.join(", ", each.kinds()),
          each.state().map(ModuleTable::word).orElse("not known"),
          Integer.toString(each.clients()),
          each.host(),
          each.stale() ? ago(Duration.between(each.confirmed(), now)) : "now");
    }
    answer.table(modules, table, nothing);
  }

  private static String word(Readiness state) {
    return state.name().toLowerCase(Locale.ROOT);
  }

  private static String ago(Duration since) {
    return "stale, " + Math.max(0, since.toSeconds()) + " s ago";
  }
}
