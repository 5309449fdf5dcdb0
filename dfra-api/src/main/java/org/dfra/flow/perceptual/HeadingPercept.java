package org.dfra.flow.perceptual;

import java.time.Instant;

/**
 * The position and heading of a robot relative to its path.
 *
 * @param measured time of the pose it is based on, UTC
 * @param frame name of the robot's base, e.g. {@code atrv1/base_link}
 * @param headingError angle to rotate by, radians, −π to π; to the left is +
 * @param headingSigma standard deviation of that, from that of the robot's yaw, radians; more than
 *     1 means that the heading is unknown
 * @param crossTrack metres from the line; left of it, in its direction, is +
 * @param alongTrack metres travelled along the line from its beginning; less than 0 before it
 * @param remainingAlongTrack metres left along the line to its end; less than 0 beyond it
 * @param distance straight-line distance to the end of the line, metres
 */
public record HeadingPercept(
    Instant measured,
    String frame,
    double headingError,
    double headingSigma,
    double crossTrack,
    double alongTrack,
    double remainingAlongTrack,
    double distance)
    implements Percept {

  /** The same with the goal straight ahead. */
  public HeadingPercept withoutHeadingError() {
    return new HeadingPercept(
        measured, frame, 0, headingSigma, crossTrack, alongTrack, remainingAlongTrack, distance);
  }
}
