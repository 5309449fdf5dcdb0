/**
 * Plans the waypoints with which a robot covers a region. Pure functions: no module, no clock, no
 * thread.
 *
 * <pre>
 *   field.geojson --RegionFile--.
 *                                +--&gt; Region --RasterPlan.of--&gt; lanes, waypoints
 *   "48.1,11.2 …" --RegionParser--'        |                         |
 *                                        |                         v
 *                             strips -&gt; lanes -&gt; gaps      Coverage of a driven path
 *                     (StripDecomposition, CoverageGapFiller)
 *                                    '-&gt; cells -&gt; order -&gt; paths between, inside the region
 *                             (CellTour, LaneSegmentSequence, InteriorPathFinder)
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.raster.RasterPlan}. Invalid input causes a {@link
 * org.dfra.behavior.GoalRefusedException} with one sentence: error, place, remedy. The reference
 * for users is {@code docs/reference/raster.md}.
 */
@NullMarked
package org.dfra.behaviors.raster;

import org.jspecify.annotations.NullMarked;
