package org.dfra.app.demo.recruit;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.UUID;
import org.dfra.app.demo.stage.Checks;
import org.dfra.app.demo.stage.Narration;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleQuery;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.module.NotReadyException;

/** What robots do until they are called, and go on with afterwards. */
final class Searches {

  /** How long a search is usually awaited. */
  static final Duration PATIENCE = Duration.ofSeconds(120);

  private static final double SWATH = 2.5; // metres
  private static final double DEPTH = 8; // to the north, metres

  private final Narration tell;
  private final ModuleDirectory directory;
  private final LocalFrame frame;
  private final Duration patience;
  private final Map<String, RasterSearch> under = new TreeMap<>(); // way, by robot

  /**
   * @param frame the world's
   * @param patience for how long a search is awaited, real time
   */
  Searches(Narration tell, ModuleDirectory directory, LocalFrame frame, Duration patience) {
    this.tell = tell;
    this.directory = directory;
    this.frame = frame;
    this.patience = patience;
  }

  /** Has a robot search a rectangle by raster, metres in the world's frame. */
  void begin(String robot, double west, double east, double south) throws Exception {
    tell.step("having " + robot + " search");
    RasterSearch search = directory.proxyFor(ModuleQuery.of(RasterSearch.class).robot(robot));
    List<LocalPosition> corners =
        List.of(
            new LocalPosition(west, south, 0),
            new LocalPosition(east, south, 0),
            new LocalPosition(east, south + DEPTH, 0),
            new LocalPosition(west, south + DEPTH, 0));
    RasterGoal goal =
        new RasterGoal(corners.stream().map(frame::toGeo).toList(), SWATH, 0.8 * SWATH, false);
    Checks.await(
        "that " + robot + " begins to search",
        patience,
        () -> {
          try {
            UUID unused = search.pursue(goal);
            return true;
          } catch (NotReadyException e) {
            return false;
          }
        });
    under.put(robot, search);
    tell.say("%s searches its half of the north by raster.", robot);
  }

  /** That robot is no more. */
  void forget(String robot) {
    under.remove(robot);
  }

  /**
   * Ends them. A search has gone on where it runs again or is finished; one that has failed, or was
   * given up, does not any more.
   *
   * @param left robots that were called away from what they did
   * @return those of them that have not gone on with their search
   */
  List<String> end(Set<String> left) throws Exception {
    List<String> idle = new ArrayList<>();
    for (Map.Entry<String, RasterSearch> each : under.entrySet()) {
      String robot = each.getKey();
      RasterSearch search = each.getValue();
      boolean wasLeft = left.contains(robot);
      if (wasLeft && !goesOn(search)) {
        idle.add(robot);
      }
      tell(robot, wasLeft, search);
      search.cancel();
    }
    return idle;
  }

  private boolean goesOn(RasterSearch search) throws Exception {
    boolean unused =
        Checks.becomes(
            patience,
            () -> {
              Phase phase = search.status().phase();
              return hasGoneOn(phase) || phase == Phase.FAILED || phase == Phase.CANCELLED;
            });
    return hasGoneOn(search.status().phase());
  }

  private static boolean hasGoneOn(Phase phase) {
    return phase == Phase.RUNNING || phase == Phase.SUCCEEDED;
  }

  private void tell(String robot, boolean wasLeft, RasterSearch search) throws RemoteException {
    tell.say(
        "%s%s has searched %.0f %% of its half: %s.",
        robot,
        wasLeft ? ", which was called away," : "",
        100 * search.status().done(),
        search.status().doing());
  }
}
