package org.dfra.behaviors.fuzzy;

/** Selects the toolbox to follow where results differ: in the centroid, and where no rule fires. */
public enum ToolboxCompatibility {
  /** Σμx / Σμ over the grid; the middle of the range where no rule fires. */
  MATLAB,
  /** ∫μx / ∫μ by the trapezoidal rule; NaN where no rule fires. */
  OCTAVE
}
