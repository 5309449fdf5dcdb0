package org.dfra.flow.perceptual;

import java.io.Serializable;
import java.time.Instant;
import java.util.List;
import org.dfra.geometry.GeoPosition;

/**
 * The mines that a robot has detected.
 *
 * @param measured time of the newest image it is based on, UTC
 * @param frame name of the frame of the positions: {@code earth}, WGS84
 * @param detections each mine once, the most probable first
 */
public record MinePercept(Instant measured, String frame, List<Detection> detections)
    implements Percept {

  public MinePercept {
    detections = List.copyOf(detections);
  }

  /**
   * A possible mine.
   *
   * @param position position on the ground, frame WGS84
   * @param probability probability that it is a mine, 0 to 1
   * @param observations number of image pairs in which it was detected
   */
  public record Detection(GeoPosition position, double probability, int observations)
      implements Serializable {

    public Detection {
      if (!(probability >= 0 && probability <= 1)) {
        throw new IllegalArgumentException("probability " + probability + " is outside 0 to 1");
      }
    }
  }
}
