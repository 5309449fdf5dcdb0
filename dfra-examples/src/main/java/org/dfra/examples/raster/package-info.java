/**
 * {@code ./dfra demo raster}: plans lanes for an operator's region, and robots search it.
 *
 * <pre>
 *   command line --RasterOptions--&gt; RasterSetup --MissionModes--&gt; Mission --&gt; LiveProgress
 *                                                                    |
 *                              RasterReport &lt;--Scores-- MissionResult--'
 * </pre>
 */
@NullMarked
package org.dfra.examples.raster;

import org.jspecify.annotations.NullMarked;
