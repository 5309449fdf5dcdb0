package org.dfra.behaviors.fuzzy;

/**
 * Whose arithmetic is followed where toolboxes differ: in the centroid, and where no rule fires.
 */
public enum ToolboxCompatibility {
  /** Σμx / Σμ over the grid; the middle of the range where no rule fires. */
  MATLAB,
  /** ∫μx / ∫μ by the trapezoidal rule; not a number where no rule fires. */
  OCTAVE
}
