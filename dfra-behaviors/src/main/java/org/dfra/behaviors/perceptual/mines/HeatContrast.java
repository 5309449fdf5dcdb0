package org.dfra.behaviors.perceptual.mines;

/**
 * A mine is warmer than its surroundings on all sides, or colder on all sides. A strip of shadow is
 * not: it continues on at least one side.
 *
 * @param minContrast minimum difference of the mine from its most similar side, kelvin
 */
record HeatContrast(double minContrast) implements Contrast {

  private static final double PER_KELVIN = 100;

  @Override
  public double score(DecodedImage picture, DetectionWindow window) {
    SummedTable heat = picture.channels().get(0);
    double inside = heat.mean(window.inside());
    BlobScore warmer = new BlobScore();
    BlobScore colder = new BlobScore();
    for (PixelRect box : window.surroundings()) {
      double difference = (inside - heat.mean(box)) / PER_KELVIN;
      warmer.add(difference);
      colder.add(-difference);
    }
    return Math.max(warmer.score(minContrast), colder.score(minContrast));
  }
}
