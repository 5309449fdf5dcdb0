package org.dfra.app.raster;

import java.util.List;
import org.dfra.behavior.BehaviorStatus;

/** Receives the progress of a search. */
@FunctionalInterface
public interface MissionListener {

  /**
   * One robot at one time.
   *
   * @param robot its name
   * @param sample its state
   * @param status progress of its search
   */
  record RobotProgress(String robot, Sample sample, BehaviorStatus status) {}

  /** The current samples of all robots, each once; ten times a second of the robots' time. */
  void onProgress(List<RobotProgress> robots);

  /** An event during the search; it is also in the result's events. */
  default void onEvent(MissionEvent mark) {}
}
