package org.dfra.flow.perceptual;

import java.time.Instant;

/**
 * How a robot stands to the way it is to go.
 *
 * @param measured time of the pose it rests on, UTC
 * @param frame name of the robot's base, e.g. {@code atrv1/base_link}
 * @param headingError by how much to turn, radians, −π to π; to the left is +
 * @param headingSigma standard deviation of that from the doubt in the robot's yaw, radians; more
 *     than 1 says that it does not know which way it faces
 * @param crossTrack metres off the line; left of it, seen along it, is +
 * @param alongTrack metres gone along the line from its beginning; less than 0 before it
 * @param remainingAlongTrack metres left along the line to its end; less than 0 beyond it
 * @param distance metres to the end of the line, straight
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
