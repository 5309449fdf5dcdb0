package org.dfra.examples.raster;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.ModuleReadings.Advice;

/** The fuzzy rules that dominated, and how often. */
final class DominantRules {

  private DominantRules() {}

  private static final class Count {
    private final int[] times;
    private double strength;

    Count(int robots) {
      times = new int[robots];
    }

    int all() {
      int all = 0;
      for (int each : times) {
        all += each;
      }
      return all;
    }
  }

  /**
   * The most frequent ones.
   *
   * @param most number of rules
   * @return headings, then a row for each rule: how often it was the strongest for each robot, its
   *     strength then, and its text
   */
  static List<List<String>> table(MissionResult flight, int most) {
    Map<String, Count> counts = new HashMap<>();
    List<RobotMissionResult> robots = flight.robots();
    for (int i = 0; i < robots.size(); i++) {
      for (Advice each : robots.get(i).readings().advice()) {
        Count count = counts.computeIfAbsent(each.reason(), unused -> new Count(robots.size()));
        count.times[i]++;
        count.strength += each.strength();
      }
    }
    List<List<String>> table = new ArrayList<>();
    List<String> headings = new ArrayList<>();
    robots.forEach(each -> headings.add(each.robot()));
    headings.addAll(List.of("Strength, mean", "Rule"));
    table.add(headings);
    counts.entrySet().stream()
        .sorted(
            Comparator.comparing((Map.Entry<String, Count> each) -> -each.getValue().all())
                .thenComparing(Map.Entry::getKey))
        .limit(most)
        .forEach(each -> table.add(row(each.getKey(), each.getValue())));
    return table;
  }

  private static List<String> row(String rule, Count count) {
    List<String> row = new ArrayList<>();
    for (int each : count.times) {
      row.add(Integer.toString(each));
    }
    row.add(String.format(Locale.ROOT, "%.2f", count.strength / count.all()));
    row.add(rule);
    return row;
  }
}
