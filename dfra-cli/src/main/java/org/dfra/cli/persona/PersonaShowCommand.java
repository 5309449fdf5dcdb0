package org.dfra.cli.persona;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.cli.module.ModuleView;
import org.dfra.cli.team.DuplicateRobotNames;
import org.dfra.cli.team.LastSeen;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.core.config.NearestName;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.directory.Persona;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra persona show}. */
@Command(name = "show", description = "Shows a robot's purpose, and what it can do.")
final class PersonaShowCommand implements Callable<Integer> {

  @Parameters(
      index = "0",
      paramLabel = "ROBOT",
      description = "The robot's name; ROBOT@HOST if several robots have this name.")
  private String robot = "";

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions options;

  /** A module with all its attributes, by their kinds. */
  record ShownModule(ModuleView module, Map<String, Attributes> attributes) {}

  /** A robot with its modules. */
  record ShownRobot(RobotView persona, List<ShownModule> modules) {}

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = options.open()) {
      ModuleDirectory directory = team.awaitDirectory();
      if (DuplicateRobotNames.choose(robot, directory.personas()).isEmpty()) { // it may be starting
        List<ModuleListing<Module>> unused =
            team.await(
                ModuleQuery.of(Module.class).robot(DuplicateRobotNames.name(robot)),
                each -> DuplicateRobotNames.isAtPlace(robot, each));
      }
      List<Persona> all = directory.personas();
      Persona persona =
          DuplicateRobotNames.choose(robot, all)
              .orElseThrow(() -> unknown(all.stream().map(Persona::robot).distinct().toList()));
      RobotView view = RobotView.of(persona);
      options
          .answer()
          .lines(
              new ShownRobot(
                  view, persona.modules().stream().map(PersonaShowCommand::shown).toList()),
              lines(view, persona.modules()));
      return ExitCode.SUCCESS;
    }
  }

  private CommandFailure unknown(List<String> names) {
    return new CommandFailure(
        ExitCode.NOT_FOUND,
        "there is no robot "
            + robot
            + NearestName.hint(
                robot,
                names,
                names.isEmpty()
                    ? "; no robot shows anything of itself"
                    : "; there is " + String.join(", ", names)));
  }

  private static ShownModule shown(ModuleListing<Module> listing) {
    Map<String, Attributes> attributes = new LinkedHashMap<>();
    listing
        .attributes()
        .forEach(
            each ->
                attributes.put(each.getClass().getSimpleName().replace("Attributes", ""), each));
    return new ShownModule(ModuleView.of(listing), attributes);
  }

  private static List<String> lines(RobotView robot, List<ModuleListing<Module>> modules) {
    List<String> lines = new ArrayList<>();
    lines.add(robot.robot() + robot.role().map(role -> ", " + role).orElse(""));
    if (!robot.host().isEmpty()) {
      lines.add("  on " + robot.host());
    }
    lines.add("  seen " + LastSeen.of(robot.stale(), robot.confirmed()));
    section(lines, "Goals", robot.goals());
    section(lines, "Limitations", robot.limitations());
    lines.add("");
    lines.add(modules.isEmpty() ? "It shows no modules." : "Modules");
    for (ModuleListing<Module> each : modules) {
      ModuleView module = ModuleView.of(each);
      lines.add(
          "  "
              + module.name()
              + ", "
              + String.join(" and ", module.kinds())
              + ": "
              + module
                  .state()
                  .map(state -> state.name().toLowerCase(Locale.ROOT))
                  .orElse("state not known")
              + (module.host().isEmpty() ? "" : " on " + module.host())
              + clients(module.clients())
              + (module.stale() ? "; " + LastSeen.of(true, module.confirmed()) : ""));
      Abilities.of(each.attributes()).forEach(line -> lines.add("    " + line));
    }
    return lines;
  }

  private static String clients(int number) {
    return switch (number) {
      case 0 -> "";
      case 1 -> ", with 1 client";
      default -> ", with " + number + " clients";
    };
  }

  private static void section(List<String> lines, String heading, List<String> sentences) {
    if (!sentences.isEmpty()) {
      lines.add("");
      lines.add(heading);
      sentences.forEach(each -> lines.add("  " + each));
    }
  }
}
