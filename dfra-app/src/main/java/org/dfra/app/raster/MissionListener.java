package org.dfra.app.raster;

import java.util.List;
import org.dfra.behavior.BehaviorStatus;

/** Is told how a search goes on. */
@FunctionalInterface
public interface MissionListener {

  /**
   * One robot at one moment.
   *
   * @param robot its name
   * @param sample where it is
   * @param status how far its search is
   */
  record RobotProgress(String robot, Sample sample, BehaviorStatus status) {}

  /** Where the robots are now, each once; ten times a second of the robots' time. */
  void onProgress(List<RobotProgress> robots);

  /** Something happened on the way; it is among the flight's marks too. */
  default void onEvent(MissionEvent mark) {}
}
