package org.dfra.cli.policy;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.geometry.GeoPosition;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.security.robot.KnownFacts;
import org.dfra.river.security.robot.NamedFact;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra policy fact}. */
@Command(
    name = "fact",
    description = "Shows what a robot knows for the conditions of its policy, or sets a fact.",
    footer = {
      "",
      "A fact stays set until it is changed, also when the robot is down. All processes of the",
      "robot know it within half a second. NAME= without a value makes the fact unknown: then a",
      "permit that needs it does not match, and a denial does."
    })
final class FactCommand implements Callable<Integer> {

  @Parameters(index = "0", paramLabel = "ROBOT", description = "Name of the robot.")
  private String robot = "";

  @Parameters(
      index = "1",
      arity = "0..1",
      paramLabel = "NAME=VALUE",
      description = "The fact to set, such as load=none (default: shows all).")
  private @Nullable String fact;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions options;

  @Override
  public Integer call() throws Exception {
    RobotControls.requireMember();
    @Nullable String wanted = fact;
    if (wanted == null) {
      show();
    } else {
      set(wanted);
    }
    return ExitCode.SUCCESS;
  }

  private void set(String wanted) throws Exception {
    int sign = wanted.indexOf('=');
    if (sign < 1) {
      throw new CommandFailure(
          ExitCode.USAGE_ERROR, "\"" + wanted + "\" is no fact; write it as load=none");
    }
    String name = wanted.substring(0, sign);
    String value = wanted.substring(sign + 1);
    try (TeamDirectory team = options.open()) {
      boolean unused =
          RobotControls.ask(
              team,
              robot,
              each -> {
                each.setFact(name, value);
                return true;
              });
    }
    options
        .answer()
        .sentence(
            Map.of("robot", robot, "name", name, "value", value),
            value.isEmpty()
                ? "The fact " + name + " of " + robot + " is unknown now."
                : "The fact " + name + " of " + robot + " is " + value + " now.");
  }

  private void show() throws Exception {
    try (TeamDirectory team = options.open()) {
      KnownFacts known = RobotControls.ask(team, robot, each -> each.facts());
      options.answer().lines(known, lines(known));
    }
  }

  private static List<String> lines(KnownFacts known) {
    List<String> lines = new ArrayList<>();
    for (NamedFact each : known.named()) {
      lines.add(
          each.name() + " is " + each.value() + ", set at " + each.set() + " by " + each.by());
    }
    if (lines.isEmpty()) {
      lines.add("No named fact is set.");
    }
    lines.add(
        known.time() == null
            ? "The time is unknown, since its clock was not set."
            : "The time is " + known.time() + ".");
    lines.add(position(known));
    return lines;
  }

  private static String position(KnownFacts known) {
    @Nullable GeoPosition position = known.position();
    if (!known.isPositionNeeded()) {
      return "No rule of its policy needs its position.";
    } else if (position == null) {
      return "Its position is unknown: no receiver or estimator has reported it for 2 s.";
    }
    return String.format(
        Locale.ROOT, "It is at %.6f, %.6f.", position.latitude(), position.longitude());
  }
}
