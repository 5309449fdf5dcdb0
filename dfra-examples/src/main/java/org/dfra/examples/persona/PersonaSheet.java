package org.dfra.examples.persona;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.cli.module.ModuleKinds;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.Persona;
import org.dfra.module.Module;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.persona.SensorAttributes;
import org.dfra.report.progress.QuantityText;
import org.dfra.report.terminal.Table;

/** The attributes of robots as text output. It makes no calls: all data are in the listing. */
final class PersonaSheet {

  private static final String LABEL = "  %-13s%s";
  private static final String TABLE = "  %s";

  /** Columns before a line of a table: these, and the indent below a sentence. */
  private static final int MARGIN = 6;

  private PersonaSheet() {}

  /**
   * A complete robot.
   *
   * @param columns of the terminal
   */
  static List<String> of(Persona persona, Instant now, int columns) {
    List<String> lines = new ArrayList<>();
    lines.add(headline(persona, now));
    persona
        .attributes()
        .ifPresent(
            robot -> {
              lines.addAll(labelled("goals", robot.goals()));
              lines.addAll(labelled("limitations", robot.limitations()));
            });
    modules(persona.modules())
        .lines(columns - MARGIN)
        .forEach(row -> lines.add(String.format(TABLE, row)));
    return lines;
  }

  /** A robot in one line: name, role, and whether the listing is stale. */
  static String headline(Persona persona, Instant now) {
    String state =
        persona.stale()
            ? String.format(
                Locale.ROOT,
                "STALE, last confirmed %.1f s ago",
                persona.staleness(now).toMillis() / 1e3)
            : "fresh";
    String role = persona.attributes().map(PersonaAttributes::role).orElse("");
    return "Robot " + persona.robot() + (role.isEmpty() ? "" : ", " + role) + ": " + state;
  }

  /** Modules as a table. */
  static Table modules(List<? extends ModuleListing<? extends Module>> modules) {
    Table table = new Table("MODULE", "STATE", "KIND", "VERSION", "CAPABILITIES", "LAST POSITION");
    for (ModuleListing<? extends Module> each : modules) {
      Optional<ModuleAttributes> module = each.attributes(ModuleAttributes.class);
      table.row(
          each.name(),
          module.map(its -> its.state().name().toLowerCase(Locale.ROOT)).orElse("?"),
          String.join(", ", ModuleKinds.names(each.module())),
          module.map(ModuleAttributes::version).orElse("?"),
          ability(each),
          each.attributes(LocationAttributes.class)
              .map(its -> QuantityText.place(its.position()))
              .orElse("unknown"));
    }
    return table;
  }

  private static String ability(ModuleListing<? extends Module> module) {
    List<String> parts = new ArrayList<>();
    module
        .attributes(GpsReceiverAttributes.class)
        .ifPresent(its -> parts.add(String.join("/", its.fixModes()) + " fix"));
    module
        .attributes(SensorAttributes.class)
        .ifPresent(its -> parts.add("up to " + rate(its.maxRate())));
    return String.join(", ", parts);
  }

  private static String rate(double hertz) {
    boolean isWhole = hertz == Math.rint(hertz);
    return String.format(Locale.ROOT, isWhole ? "%.0f Hz" : "%.2f Hz", hertz);
  }

  private static List<String> labelled(String label, List<String> texts) {
    List<String> lines = new ArrayList<>();
    for (String text : texts) {
      lines.add(String.format(LABEL, lines.isEmpty() ? label : "", text));
    }
    return lines;
  }
}
