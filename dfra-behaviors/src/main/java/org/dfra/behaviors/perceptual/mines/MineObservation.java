package org.dfra.behaviors.perceptual.mines;

import java.util.List;

/**
 * Images taken at about one time, at most one per band, with their viewpoints.
 *
 * @param views of the images, at least one
 */
public record MineObservation(List<LocatedDetections> views) {

  public MineObservation {
    views = List.copyOf(views);
  }

  /**
   * One image.
   *
   * @param viewpoint pose of the robot
   * @param detections in the image
   */
  public record LocatedDetections(Viewpoint viewpoint, ImageDetections detections) {

    /** Whether a mine at a map position would be visible. */
    public boolean covers(GroundPoint place) {
      return detections.covers(viewpoint.toBase(place));
    }

    /** Detections, in map coordinates. */
    public List<GroundPoint> points() {
      return detections.points().stream().map(viewpoint::toMap).toList();
    }
  }
}
