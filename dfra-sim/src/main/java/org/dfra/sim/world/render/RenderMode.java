package org.dfra.sim.world.render;

/** What a picture shows. */
public enum RenderMode {
  /** Light: each sample is 0xRRGGBB. */
  VISIBLE,
  /** Heat: each sample is a temperature in hundredths of a kelvin. */
  THERMAL,
  /** Whose pixel it is: each sample is the label of what is seen there, 0 for what has none. */
  LABELS
}
