package org.dfra.sim.world.render;

import org.dfra.sim.world.description.WorldDescription.WeatherDescription;
import org.dfra.sim.world.render.MeshFace.Paint;
import org.dfra.sim.world.render.Renderer.RenderMode;

/** The sun and the sky: brightness and temperature of surfaces by their orientation. Immutable. */
final class Light {

  private static final double AMBIENT = 0.55; // part of daylight that comes from the sky
  private static final double NIGHT = 0.07; // of daylight
  private static final int ELEVATIONS = 256;
  private static final int[] HORIZON = {206, 214, 222};
  private static final int[] ZENITH = {96, 146, 212};

  /** Apparent sky temperature below that of the air, kelvin. */
  private static final double COLD_HORIZON = 8;

  private static final double COLD_ZENITH = 45;

  final double sunX;
  final double sunY;
  final double sunZ;
  final double warming;
  final double air; // kelvin

  private final double daylight;
  private final int[] skyColours = new int[ELEVATIONS];
  private final int[] skyTemperatures = new int[ELEVATIONS];

  Light(WeatherDescription weather) {
    double level = StrictMath.cos(weather.sunElevation());
    sunX = level * StrictMath.cos(weather.sunAzimuth());
    sunY = level * StrictMath.sin(weather.sunAzimuth());
    sunZ = StrictMath.sin(weather.sunElevation());
    warming = weather.groundWarming();
    air = weather.temperature();
    daylight = Math.max(NIGHT, Math.min(1, 0.1 + 3 * sunZ));
    for (int i = 0; i < ELEVATIONS; i++) {
      double part = Math.sqrt(i / (ELEVATIONS - 1.0));
      int colour = 0;
      for (int c = 0; c < 3; c++) {
        double value = daylight * (HORIZON[c] + part * (ZENITH[c] - HORIZON[c]));
        colour = colour << 8 | (int) Math.round(value);
      }
      skyColours[i] = colour;
      skyTemperatures[i] = hundredths(air - COLD_HORIZON - part * (COLD_ZENITH - COLD_HORIZON));
    }
  }

  /** Whether the sun casts shadows. */
  boolean hasShadows() {
    return sunZ > 0.05;
  }

  /**
   * The sky.
   *
   * @param up sine of the elevation above the horizon, 0 to 1
   */
  int sky(RenderMode band, double up) {
    int at = (int) (up * (ELEVATIONS - 1));
    return switch (band) {
      case VISIBLE -> skyColours[at];
      case THERMAL -> skyTemperatures[at];
      case LABELS -> 0;
    };
  }

  /** Brightness of a surface, relative to the ground in full sun. */
  double brightness(double nx, double ny, double nz) {
    double facing = sunZ > 0 ? Math.max(0, nx * sunX + ny * sunY + nz * sunZ) : 0;
    double full = AMBIENT + (1 - AMBIENT) * Math.max(sunZ, 0.3);
    // From below a surface sees the ground and not the sky.
    double sky = AMBIENT * (0.75 + 0.25 * nz);
    return daylight * (sky + (1 - AMBIENT) * facing) / full;
  }

  /** Brightness of the ground in shadow, relative to full sun. */
  double shadow() {
    return AMBIENT / (AMBIENT + (1 - AMBIENT) * Math.max(sunZ, 0.3));
  }

  /** A sample of a surface with this appearance and orientation. */
  int surface(RenderMode band, Paint paint, double nx, double ny, double nz) {
    return switch (band) {
      case VISIBLE -> lit(paint.colour(), brightness(nx, ny, nz));
      case THERMAL -> {
        double facing = Math.max(0, nx * sunX + ny * sunY + nz * sunZ);
        yield hundredths(air + paint.warmth() + paint.sunlit() * warming * facing);
      }
      case LABELS -> paint.label();
    };
  }

  /** A colour in more or less light. */
  static int lit(int colour, double brightness) {
    int red = (int) Math.min(255, (colour >> 16 & 0xFF) * brightness);
    int green = (int) Math.min(255, (colour >> 8 & 0xFF) * brightness);
    int blue = (int) Math.min(255, (colour & 0xFF) * brightness);
    return red << 16 | green << 8 | blue;
  }

  double daylight() {
    return daylight;
  }

  /** Hundredths of a kelvin. */
  static int hundredths(double kelvin) {
    return (int) Math.round(kelvin * 100);
  }
}
