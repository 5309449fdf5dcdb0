package org.dfra.sim.world.description;

import java.util.Locale;

/** What moves a robot, and how big it is where nothing else is written. */
public enum VehicleType {
  /** On four wheels, skid-steered; as big as an ATRV-Jr. */
  UGV(0.78, 0.64, 0.55),
  /** A multicopter. */
  UAV(0.6, 0.6, 0.25);

  private final double length;
  private final double width;
  private final double height;

  VehicleType(double length, double width, double height) {
    this.length = length;
    this.width = width;
    this.height = height;
  }

  /** Along its x axis, metres. */
  public double length() {
    return length;
  }

  /** Along its y axis, metres. */
  public double width() {
    return width;
  }

  /** From what it stands on to its top, masts left out, metres. */
  public double height() {
    return height;
  }

  /** As it is written in XML: {@code ugv}, {@code uav}. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }
}
