package org.dfra.sim.world.description;

import java.util.Locale;

/** Type of a robot's drive, with its default size. */
public enum VehicleType {
  /** On four wheels, skid-steered; the size of an ATRV-Jr. */
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

  /** From its base to its top, without masts, metres. */
  public double height() {
    return height;
  }

  /** Its name in XML: {@code ugv}, {@code uav}. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }
}
