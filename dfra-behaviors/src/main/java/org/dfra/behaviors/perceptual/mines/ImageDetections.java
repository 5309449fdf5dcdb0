package org.dfra.behaviors.perceptual.mines;

import java.util.List;
import org.dfra.flow.sensor.CameraImage.Band;

/** What one camera has to say of one image. Immutable. */
public final class ImageDetections {

  private final Band band;
  private final WindowGrid windows;
  private final List<GroundPoint> found;

  ImageDetections(Band band, WindowGrid windows, List<GroundPoint> found) {
    this.band = band;
    this.windows = windows;
    this.found = List.copyOf(found);
  }

  /** What the image shows. */
  public Band band() {
    return band;
  }

  /** Where there is what looks like a mine, the strongest first; x forward of the robot's base. */
  public List<GroundPoint> points() {
    return found;
  }

  /** Whether it would show a mine there. */
  public boolean covers(GroundPoint spot) {
    return windows.covers(spot);
  }
}
