package org.dfra.examples.mission;

import java.util.List;
import org.dfra.time.ClockOffset;

/**
 * Readings of a robot's modules during the search. Times are measurement times in seconds since the
 * search began.
 *
 * @param fixes of its receivers, each once
 * @param advice outputs of its fuzzy rules
 * @param clearances by its range filter
 * @param teammates reported positions of other robots, each instant of each once
 */
public record ModuleReadings(
    List<Fix> fixes,
    List<Advice> advice,
    List<ClearanceReading> clearances,
    List<TeammateDistance> teammates) {

  /** Without subscriptions. */
  public static final ModuleReadings EMPTY =
      new ModuleReadings(List.of(), List.of(), List.of(), List.of());

  public ModuleReadings {
    fixes = List.copyOf(fixes);
    advice = List.copyOf(advice);
    clearances = List.copyOf(clearances);
    teammates = List.copyOf(teammates);
  }

  /**
   * A receiver's position.
   *
   * @param receiver the module's name
   * @param east in the region's frame, metres
   * @param north likewise
   */
  public record Fix(double time, String receiver, double east, double north) {}

  /**
   * The output of the rules.
   *
   * @param speed recommended speed, metres per second
   * @param yawRate radians per second, to the left is +
   * @param reason the strongest rule
   * @param strength its firing strength, 0 to 1
   */
  public record Advice(double time, double speed, double yawRate, String reason, double strength) {}

  /**
   * The clearance that the robot measured, metres from its body.
   *
   * @param left of it
   * @param centre ahead of it
   * @param right of it
   */
  public record ClearanceReading(double time, double left, double centre, double right) {}

  /**
   * Another robot, at an instant for which both had an estimate.
   *
   * @param time of that instant, by the clock of the reporting robot
   * @param robot the other's name
   * @param distance from base to base by both estimates, metres
   * @param clock offset of the other's clock to that of the reporting robot
   */
  public record TeammateDistance(double time, String robot, double distance, ClockOffset clock) {}
}
