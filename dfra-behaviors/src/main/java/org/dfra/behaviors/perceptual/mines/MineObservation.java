package org.dfra.behaviors.perceptual.mines;

import java.util.List;

/**
 * Images taken at about one time, of each band one at most, and where each was taken.
 *
 * @param views of the images, one at least
 */
public record MineObservation(List<LocatedDetections> views) {

  public MineObservation {
    views = List.copyOf(views);
  }

  /**
   * One image.
   *
   * @param viewpoint where the robot stood
   * @param detections what was seen
   */
  public record LocatedDetections(Viewpoint viewpoint, ImageDetections detections) {

    /** Whether it would show a mine at a place of the map. */
    public boolean covers(GroundPoint place) {
      return detections.covers(viewpoint.toBase(place));
    }

    /** What looks like a mine, on the map. */
    public List<GroundPoint> points() {
      return detections.points().stream().map(viewpoint::toMap).toList();
    }
  }
}
