package org.dfra.flow.perceptual;

import java.io.Serializable;
import java.time.Instant;
import java.util.List;
import org.dfra.geometry.GeoPosition;

/**
 * What a robot takes for mines.
 *
 * @param measured time of the newest image it rests on, UTC
 * @param frame name of the frame that the positions are of: {@code earth}, WGS84
 * @param detections each once, the likeliest first
 */
public record MinePercept(Instant measured, String frame, List<Detection> detections)
    implements Percept {

  public MinePercept {
    detections = List.copyOf(detections);
  }

  /**
   * Something that may be a mine.
   *
   * @param position where on the ground, frame WGS84
   * @param probability that it is one, 0 to 1
   * @param observations how many pairs of images it was seen in
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
