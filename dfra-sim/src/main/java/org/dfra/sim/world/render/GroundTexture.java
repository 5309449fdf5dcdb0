package org.dfra.sim.world.render;

import org.dfra.sim.world.noise.RandomStream;
import org.dfra.sim.world.render.Renderer.RenderMode;

/**
 * The ground: a meadow with lush and dry patches, fixed to the world. Dry patches are warmer in the
 * sun. Immutable.
 */
final class GroundTexture {

  private static final int PATCH_BITS = 10;
  private static final double PATCH_TEXEL = 1 / 16.0; // metres
  private static final int BLADE_BITS = 9;
  private static final double BLADE_TEXEL = 1 / 64.0; // metres

  private static final int[] SOIL = {74, 68, 46};
  private static final int[] GRASS = {82, 108, 50};
  private static final int[] DRY = {150, 140, 84};

  private static final double WARMEST = 0.25; // additional solar warming of dry patches
  private static final double BLADE_WARMTH = 0.35; // kelvin, of the largest pattern

  /** Fraction of the solar warming on ground in shadow. */
  private static final double SHADED = 0.45;

  private final MipmapTexture patches;
  private final MipmapTexture blades;
  private final Light light;
  private final int[] colours = new int[256];
  private final int[] temperatures = new int[256];
  private final int[] shadedTemperatures = new int[256];
  private final int shade; // of 256

  GroundTexture(RandomStream draws, Light light) {
    this.light = light;
    double[] patch = new double[1 << 2 * PATCH_BITS];
    MipmapTexture.addNoise(draws.substream("wide"), PATCH_BITS, 128, 38, patch);
    MipmapTexture.addNoise(draws.substream("broad"), PATCH_BITS, 32, 24, patch);
    MipmapTexture.addNoise(draws.substream("narrow"), PATCH_BITS, 8, 12, patch);
    patches = new MipmapTexture(PATCH_BITS, PATCH_TEXEL, patch);
    double[] blade = new double[1 << 2 * BLADE_BITS];
    MipmapTexture.addNoise(draws.substream("tufts"), BLADE_BITS, 8, 26, blade);
    MipmapTexture.addNoise(draws.substream("stems"), BLADE_BITS, 2, 22, blade);
    MipmapTexture.addNoise(draws.substream("blades"), BLADE_BITS, 1, 14, blade);
    blades = new MipmapTexture(BLADE_BITS, BLADE_TEXEL, blade);
    shade = light.hasShadows() ? (int) Math.round(256 * light.shadow()) : 256;
    for (int i = 0; i < 256; i++) {
      double dryness = (i - 128) / 128.0;
      colours[i] = colour(dryness);
      double warming = light.warming * (1 + WARMEST * dryness);
      temperatures[i] = Light.hundredths(light.air + warming);
      shadedTemperatures[i] =
          Light.hundredths(light.air + (light.hasShadows() ? SHADED : 1) * warming);
    }
  }

  private int colour(double dryness) {
    int[] other = dryness < 0 ? SOIL : DRY;
    double part = Math.min(1, Math.abs(dryness));
    int colour = 0;
    for (int c = 0; c < 3; c++) {
      double value = light.daylight() * (GRASS[c] + part * (other[c] - GRASS[c]));
      colour = colour << 8 | (int) Math.round(value);
    }
    return colour;
  }

  /**
   * A sample of the ground.
   *
   * @param area that the pixel covers, square metres
   */
  int sample(RenderMode band, double east, double north, double area, boolean isShaded) {
    int patch = patches.at(east, north, area) + 128;
    int blade = blades.at(east, north, area);
    if (band == RenderMode.THERMAL) {
      int[] table = isShaded ? shadedTemperatures : temperatures;
      return table[patch] + (int) (blade * (BLADE_WARMTH * 100 / 128));
    }
    int factor = 256 + blade;
    factor = isShaded ? factor * shade >> 8 : factor;
    int colour = colours[patch];
    int red = Math.min(255, (colour >> 16 & 0xFF) * factor >> 8);
    int green = Math.min(255, (colour >> 8 & 0xFF) * factor >> 8);
    int blue = Math.min(255, (colour & 0xFF) * factor >> 8);
    return red << 16 | green << 8 | blue;
  }

  /** Temperature of the ground there in the sun, kelvin; mean over a square metre. */
  double temperature(double east, double north) {
    return temperatures[patches.at(east, north, 1) + 128] / 100.0;
  }
}
