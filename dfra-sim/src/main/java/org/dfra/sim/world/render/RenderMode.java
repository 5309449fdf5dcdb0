package org.dfra.sim.world.render;

/** The content of an image. */
public enum RenderMode {
  /** Visible light: each sample is 0xRRGGBB. */
  VISIBLE,
  /** Heat: each sample is a temperature in hundredths of a kelvin. */
  THERMAL,
  /** Labels: each sample is the label of the visible object, 0 for none. */
  LABELS
}
