package org.dfra.drivers.laser.lms;

/** What the laser counts distances in; in the order of its two bits in a scan. */
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

  /** One of it, metres. */
  public double metres() {
    return metres;
  }

  /**
   * Of a distance told in it, one sigma, metres: that of the laser, or the unit where it is more.
   */
  public double accuracy() {
    return accuracy;
  }

  /** {@code mm}. */
  public String word() {
    return name().toLowerCase(java.util.Locale.ROOT);
  }
}
