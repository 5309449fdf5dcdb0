package org.dfra.drivers.pantilt.ptu;

/** One of the two axes. */
public enum PtuAxis {
  /** About the vertical; to the left is +. */
  PAN('P'),
  /** About the horizontal, after pan; up is +. */
  TILT('T');

  private final char letter;

  PtuAxis(char letter) {
    this.letter = letter;
  }

  /** The first letter of its commands. */
  public char letter() {
    return letter;
  }

  /** {@code pan} or {@code tilt}. */
  @Override
  public String toString() {
    return this == PAN ? "pan" : "tilt";
  }
}
