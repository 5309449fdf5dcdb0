package org.dfra.examples.recruit;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.examples.recruit.Snapshot.Availability;
import org.dfra.examples.recruit.Snapshot.Robot;
import org.dfra.report.progress.QuantityText;
import org.dfra.report.terminal.TextWrap;
import org.jspecify.annotations.Nullable;

/**
 * A team at one moment, as lines: one for each robot and one for the call. Columns have a constant
 * width, so that the display is stable; with names of five letters a line has 78 characters, and a
 * narrower terminal shows the numbers in a line of their own. A question mark is an unknown value,
 * a blank means that there is none.
 */
final class SnapshotLines {

  private static final int SHORTEST_NAME = 5;
  private static final int BAR = 5;
  private static final String UNKNOWN = "?";
  private static final String INDENT = "   ";

  /** Columns of a line beside the robot's name. */
  private static final int REST = 73;

  private final int name;
  private final boolean isNarrow;
  private final List<String> lines = new ArrayList<>();

  private SnapshotLines(int name, int columns) {
    this.name = name;
    this.isNarrow = name + REST > columns;
  }

  /**
   * The lines, after an empty line as separator.
   *
   * @param columns maximum width of a line
   */
  static List<String> of(Snapshot now, int columns) {
    int longest = now.robots().stream().mapToInt(each -> each.name().length()).max().orElse(0);
    SnapshotLines table = new SnapshotLines(Math.max(longest, SHORTEST_NAME), columns);
    table.lines.add("");
    String head = "Now, after %.0f s of the robots' time; no message loss is simulated:";
    table.sentence(String.format(Locale.ROOT, head, now.seconds()), columns);
    table.row("ROBOT", "ACTIVITY", "RECRUITMENT", "SHAME", "DISTANCE", "LEASE", "CHARGE");
    now.robots().forEach(table::row);
    table.sentence(call(now), columns);
    return List.copyOf(table.lines);
  }

  private void sentence(String text, int columns) {
    lines.addAll(TextWrap.hangingIndent(text, columns, INDENT.length()));
  }

  private void row(Robot robot) {
    switch (robot.fate()) {
      case DEAD -> row(robot.name(), "dead", "", "", "", "", "");
      case ABSENT -> row(robot.name(), UNKNOWN, UNKNOWN, UNKNOWN, "", "", charge(robot));
      case PRESENT, UNREACHABLE ->
          row(
              robot.name(),
              does(robot),
              recruitment(robot),
              shame(robot),
              number("%.1f m", robot.distance()),
              number("%.0f s", robot.lease()),
              charge(robot));
    }
  }

  private void row(
      String robot,
      String does,
      String recruitment,
      String shame,
      String distance,
      String lease,
      String charge) {
    String words =
        String.format(Locale.ROOT, "%-" + name + "s  %-16s  %-18s", robot, does, recruitment);
    String numbers =
        String.format(Locale.ROOT, "  %-10s%8s  %5s  %6s", shame, distance, lease, charge);
    if (!isNarrow) {
      lines.add((words + numbers).stripTrailing());
      return;
    }
    lines.add(words.stripTrailing());
    lines.add((INDENT + numbers).stripTrailing());
  }

  /** A robot's activity, the most urgent one that it reports. */
  private static String does(Robot robot) {
    RecruitmentStatus agent = robot.agent();
    if (agent != null && agent.responderPhase().isCommitted()) {
      return switch (agent.responderPhase()) {
        case TRAVELLING -> "on its way";
        case LEASED -> "observing";
        default -> "there";
      };
    }
    return robot.isFlying() ? "flying" : does(robot.search());
  }

  private static String does(@Nullable BehaviorStatus search) {
    if (search == null) {
      return "waiting";
    }
    long percent = (long) Math.floor(100 * search.completion() + 1e-9);
    return switch (search.phase()) {
      case RUNNING -> "searching, " + percent + " %";
      case PAUSED -> "paused, " + percent + " %";
      case SUCCEEDED -> "search complete";
      case FAILED -> "search failed";
      case CANCELLED -> "stopped, " + percent + " %";
      case IDLE -> "waiting";
    };
  }

  private static String recruitment(Robot robot) {
    if (robot.fate() == Availability.UNREACHABLE) {
      return "unreachable";
    }
    RecruitmentStatus agent = robot.agent();
    if (agent == null) {
      return "idle";
    } else if (agent.responderPhase().isCommitted()) {
      return "responds to " + name(agent.helpedRobot());
    }
    return switch (agent.responderPhase()) {
      case OFFERED -> "offers to " + name(agent.helpedRobot());
      default -> requesting(agent);
    };
  }

  private static String requesting(RecruitmentStatus agent) {
    if (agent.requesterPhase() == RequesterPhase.IDLE) {
      return "idle";
    } else if (agent.requesterPhase() == RequesterPhase.BEING_HELPED) {
      return "helped by " + name(agent.helperRobot());
    }
    return agent.helperRobot() == null ? "requests" : "awaits " + agent.helperRobot();
  }

  private static String name(@Nullable String robot) {
    return robot == null ? UNKNOWN : robot;
  }

  private static String shame(Robot robot) {
    double urge = robot.agent() == null ? 0 : robot.agent().urge();
    double down = Math.floor(100 * urge + 1e-9) / 100; // 1.00 is where it offers, not below
    int full = (int) Math.floor(BAR * urge + 1e-9);
    return String.format(Locale.ROOT, "%s%s %.2f", "#".repeat(full), ".".repeat(BAR - full), down);
  }

  private static String number(String format, @Nullable Double value) {
    return value == null ? "" : String.format(Locale.ROOT, format, value);
  }

  private static String charge(Robot robot) {
    Double charge = robot.charge();
    return charge == null ? UNKNOWN : number("%.0f %%", 100 * charge);
  }

  private static String call(Snapshot now) {
    CallState call = now.call();
    if (call == null) {
      return "No robot calls for help.";
    }
    StringBuilder text = new StringBuilder();
    text.append(
        String.format(
            Locale.ROOT,
            "Call %d by %s, %.0f s ago: ",
            call.number(),
            call.requester(),
            call.seconds(now.time())));
    text.append(call.chosen() == null ? "no helper chosen" : call.chosen() + " chosen");
    if (!call.lost().isEmpty()) {
      text.append(", ").append(String.join(" and ", call.lost())).append(" lost");
    }
    text.append("; HELP sent ").append(QuantityText.count(call.rounds(), "time"));
    return text.append(", ").append(QuantityText.count(call.messages(), "message")).toString();
  }
}
