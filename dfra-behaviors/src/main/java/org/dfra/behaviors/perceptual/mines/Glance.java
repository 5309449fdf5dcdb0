package org.dfra.behaviors.perceptual.mines;

import java.util.List;
import org.dfra.flow.sensor.CameraImage.Band;

/** What one camera has to say of one image. Immutable. */
public final class Glance {

  private final Band band;
  private final Windows windows;
  private final List<Spot> found;

  Glance(Band band, Windows windows, List<Spot> found) {
    this.band = band;
    this.windows = windows;
    this.found = List.copyOf(found);
  }

  /** What the image shows. */
  public Band band() {
    return band;
  }

  /** Where there is what looks like a mine, the strongest first; x forward of the robot's base. */
  public List<Spot> found() {
    return found;
  }

  /** Whether it would show a mine there. */
  public boolean sees(Spot spot) {
    return windows.see(spot);
  }
}
