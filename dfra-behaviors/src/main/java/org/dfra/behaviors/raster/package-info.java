/**
 * From a region to the waypoints that a robot drives to see all of it. Pure functions: no module,
 * no clock, no thread.
 *
 * <pre>
 *   field.geojson --RegionFile--.
 *                                +--&gt; Region --RasterPlan.of--&gt; lanes, waypoints
 *   "48.1,11.2 …" --RegionParser--'        |                         |
 *                                        |                         v
 *                             strips -&gt; lanes -&gt; gaps      Coverage of a driven path
 *                               (StripDecomposition)     (Gaps)
 *                                    '-&gt; cells -&gt; order -&gt; ways between, inside the region
 *                                         (CellTour)  (LaneSegmentSequence)    (Interior)
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.raster.RasterPlan}. Whatever cannot be planned ends in a
 * {@link org.dfra.behavior.GoalRefusedException} with one sentence: what is wrong, where, what to
 * do. The reference for users is {@code docs/reference/raster.md}.
 */
@NullMarked
package org.dfra.behaviors.raster;

import org.jspecify.annotations.NullMarked;
