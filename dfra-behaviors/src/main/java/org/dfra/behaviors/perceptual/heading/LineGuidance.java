package org.dfra.behaviors.perceptual.heading;

import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.geometry.LocalPosition;

/**
 * Guides along a line by a target point on it ahead of the robot.
 *
 * <pre>
 *   from ----------+-----------------x------------ to      x: target point, lookahead metres ahead
 *                  | cross track     '                        of the foot, never beyond the end
 *                  robot . . . . . . ' target heading
 * </pre>
 *
 * @param lookahead metres from the robot's foot on the line to the point; a shorter one turns to
 *     the line sooner
 */
record LineGuidance(double lookahead) {

  /** A line shorter than this is treated as its end point, metres. */
  static final double POINT = 0.05;

  /**
   * Heading error and cross-track error to the line.
   *
   * @param from its beginning in the pose's frame
   * @param to its end in the pose's frame
   * @param base name of the robot's base frame
   */
  HeadingPercept towards(PoseEstimate pose, LocalPosition from, LocalPosition to, String base) {
    double east = to.east() - from.east();
    double north = to.north() - from.north();
    double length = Math.hypot(east, north);
    double toEndEast = to.east() - pose.east();
    double toEndNorth = to.north() - pose.north();
    double distance = Math.hypot(toEndEast, toEndNorth);
    if (length < POINT) {
      return percept(
          pose, base, Math.atan2(toEndNorth, toEndEast), 0, -distance, distance, distance);
    }
    double ux = east / length;
    double uy = north / length;
    double dx = pose.east() - from.east();
    double dy = pose.north() - from.north();
    double along = dx * ux + dy * uy;
    double crossTrack = ux * dy - uy * dx;
    double aim = Math.min(length, Math.max(0, along) + lookahead);
    double aimEast = from.east() + aim * ux - pose.east();
    double aimNorth = from.north() + aim * uy - pose.north();
    return percept(
        pose, base, Math.atan2(aimNorth, aimEast), crossTrack, along, length - along, distance);
  }

  private static HeadingPercept percept(
      PoseEstimate pose,
      String base,
      double bearing,
      double crossTrack,
      double along,
      double remaining,
      double distance) {
    double error = Math.IEEEremainder(bearing - pose.yaw(), 2 * Math.PI);
    return new HeadingPercept(
        pose.measured(), base, error, pose.yawSigma(), crossTrack, along, remaining, distance);
  }
}
