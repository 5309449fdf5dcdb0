package org.dfra.drivers.laser.lms;

/** Units of the laser's distances; in the order of the two bits in a scan. */
public enum LmsUnit {
  /** Centimetres. */
  CM(0.01, 0.01),
  /** Millimetres. */
  MM(0.001, 0.005),
  /** Decimetres. */
  DM(0.1, 0.1);

  private final double metres;
  private final double accuracy;

  LmsUnit(double metres, double accuracy) {
    this.metres = metres;
    this.accuracy = accuracy;
  }

  /** The unit in metres. */
  public double metres() {
    return metres;
  }

  /**
   * Accuracy of a distance in this unit, one sigma, metres: the laser's, or the unit if that is
   * larger.
   */
  public double accuracy() {
    return accuracy;
  }

  /** {@code mm}. */
  public String word() {
    return name().toLowerCase(java.util.Locale.ROOT);
  }
}
