package org.dfra.examples.mission;

import java.util.List;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.examples.mission.RobotLog.Sample;

/** Receives the progress of a search. */
@FunctionalInterface
public interface MissionProgressListener {

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

  /**
   * An event of a robot during the search, such as that a process was killed.
   *
   * @param time seconds since the search began
   * @param robot the robot's name
   * @param what the event, in a few words
   */
  record MissionEvent(double time, String robot, String what) {}
}
