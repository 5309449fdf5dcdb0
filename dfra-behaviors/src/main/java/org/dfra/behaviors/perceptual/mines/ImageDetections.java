package org.dfra.behaviors.perceptual.mines;

import java.util.List;
import org.dfra.flow.sensor.CameraImage.Band;

/** Detections in one image of one camera. Immutable. */
public final class ImageDetections {

  private final Band band;
  private final WindowGrid windows;
  private final List<GroundPoint> found;

  ImageDetections(Band band, WindowGrid windows, List<GroundPoint> found) {
    this.band = band;
    this.windows = windows;
    this.found = List.copyOf(found);
  }

  /** The image's spectral band. */
  public Band band() {
    return band;
  }

  /** Positions of mine-like objects, the strongest first; x forward of the robot's base. */
  public List<GroundPoint> points() {
    return found;
  }

  /** Whether a mine there would be visible. */
  public boolean covers(GroundPoint spot) {
    return windows.covers(spot);
  }
}
