package org.dfra.examples.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.ModuleReadings.Fix;
import org.dfra.examples.mission.RobotLog.Sample;

/**
 * An interval in which a receiver published no position.
 *
 * @param receiver the module's name
 * @param from seconds since the search began
 * @param to likewise
 */
public record ReceiverOutage(String receiver, double from, double to) {

  /** A working receiver publishes a position every second. */
  private static final double NOTED = 2.5; // seconds

  /** All outages of a robot, grouped by receiver. */
  public static List<ReceiverOutage> all(RobotMissionResult flight) {
    Map<String, List<Fix>> byReceiver = new TreeMap<>();
    for (Fix each : flight.readings().fixes()) {
      byReceiver.computeIfAbsent(each.receiver(), unused -> new ArrayList<>()).add(each);
    }
    List<Sample> samples = flight.samples();
    double end = samples.isEmpty() ? 0 : samples.get(samples.size() - 1).time();
    List<ReceiverOutage> all = new ArrayList<>();
    byReceiver.forEach(
        (receiver, fixes) -> {
          double last = 0;
          for (Fix each : fixes) {
            note(receiver, last, each.time(), all);
            last = each.time();
          }
          note(receiver, last, end, all);
        });
    return all;
  }

  private static void note(String receiver, double from, double to, List<ReceiverOutage> all) {
    if (to - from > NOTED) {
      all.add(new ReceiverOutage(receiver, from, to));
    }
  }
}
