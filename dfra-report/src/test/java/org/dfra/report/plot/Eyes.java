package org.dfra.report.plot;

import java.awt.Color;
import java.util.List;

/**
 * How colours look to eyes without one kind of cones: the matrices of Machado, Oliveira and
 * Fernandes ("A physiologically-based model for simulation of color vision deficiency", 2009) for
 * full severity, on linear sRGB.
 */
final class Eyes {

  static final List<double[][]> ALL =
      List.of(
          new double[][] {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          new double[][] {
            {0.152286, 1.052583, -0.204868},
            {0.114503, 0.786281, 0.099216},
            {-0.003882, -0.048116, 1.051998}
          },
          new double[][] {
            {0.367322, 0.860646, -0.227968},
            {0.280085, 0.672501, 0.047413},
            {-0.011820, 0.042940, 0.968881}
          },
          new double[][] {
            {1.255528, -0.076749, -0.178779},
            {-0.078411, 0.930809, 0.147602},
            {0.004733, 0.691367, 0.303900}
          });

  private Eyes() {}

  /** Distance in CIELAB, where 2 can just be distinguished side by side. */
  static double distance(double[][] eye, Color one, Color other) {
    double[] a = lab(eye, one);
    double[] b = lab(eye, other);
    return Math.sqrt(
        Math.pow(a[0] - b[0], 2) + Math.pow(a[1] - b[1], 2) + Math.pow(a[2] - b[2], 2));
  }

  /** Lightness L* from 0 to 100, then a* and b*. */
  static double[] lab(double[][] eye, Color colour) {
    double[] rgb = {linear(colour.getRed()), linear(colour.getGreen()), linear(colour.getBlue())};
    double r = seen(eye[0], rgb);
    double g = seen(eye[1], rgb);
    double b = seen(eye[2], rgb);
    double x = curve((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
    double y = curve(0.2126 * r + 0.7152 * g + 0.0722 * b);
    double z = curve((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
    return new double[] {116 * y - 16, 500 * (x - y), 200 * (y - z)};
  }

  private static double seen(double[] row, double[] rgb) {
    double sum = row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2];
    return Math.min(1, Math.max(0, sum));
  }

  private static double linear(int channel) {
    double part = channel / 255.0;
    return part <= 0.04045 ? part / 12.92 : Math.pow((part + 0.055) / 1.055, 2.4);
  }

  private static double curve(double t) {
    return t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16.0 / 116;
  }
}
