package org.dfra.drivers.pantilt.ptu;

/** One of the two axes. */
public enum PtuAxis {
  /** About the vertical; to the left is +. */
  PAN('P'),
  /** About the horizontal, after pan; up is +. */
  TILT('T');

  private final char envelope;

  PtuAxis(char envelope) {
    this.envelope = envelope;
  }

  /** The first letter of its commands. */
  public char letter() {
    return envelope;
  }

  /** {@code pan} or {@code tilt}. */
  @Override
  public String toString() {
    return this == PAN ? "pan" : "tilt";
  }
}
