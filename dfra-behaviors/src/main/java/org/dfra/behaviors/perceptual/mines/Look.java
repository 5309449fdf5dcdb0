package org.dfra.behaviors.perceptual.mines;

import java.util.List;

/**
 * Images taken at about one time, of each band one at most, and where each was taken.
 *
 * @param views of the images, one at least
 */
public record Look(List<View> views) {

  public Look {
    views = List.copyOf(views);
  }

  /**
   * One image.
   *
   * @param from where the robot stood
   * @param glance what was seen
   */
  public record View(Viewpoint from, Glance glance) {

    /** Whether it would show a mine at a place of the map. */
    public boolean sees(Spot place) {
      return glance.sees(from.toBase(place));
    }

    /** What looks like a mine, on the map. */
    public List<Spot> found() {
      return glance.found().stream().map(from::toMap).toList();
    }
  }
}
