package org.dfra.app.raster;

import java.util.List;
import org.dfra.time.ClockOffset;

/**
 * What modules of a robot told on the way. Times are seconds since the search began, of what was
 * measured.
 *
 * @param fixes of its receivers, each once
 * @param advice of its fuzzy rules
 * @param clearances by its range filter
 * @param teammates what it told of other robots, each instant of each once
 */
public record ModuleReadings(
    List<Fix> fixes,
    List<Advice> advice,
    List<ClearanceReading> clearances,
    List<TeammateDistance> teammates) {

  /** Where nobody listened. */
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
   * What the rules advised.
   *
   * @param speed metres per second
   * @param yawRate radians per second, to the left is +
   * @param reason the rule that spoke loudest
   * @param strength how much it applied, 0 to 1
   */
  public record Advice(double time, double speed, double yawRate, String reason, double strength) {}

  /**
   * How much room the robot saw, metres from its body.
   *
   * @param left of it
   * @param centre ahead of it
   * @param right of it
   */
  public record ClearanceReading(double time, double left, double centre, double right) {}

  /**
   * Another robot, at an instant at which both believed to be somewhere.
   *
   * @param time of that instant, by the clock of the robot that tells
   * @param robot the other's name
   * @param distance from base to base by both estimates, metres
   * @param clock how far the other's clock is ahead of that of the robot that tells
   */
  public record TeammateDistance(double time, String robot, double distance, ClockOffset clock) {}
}
