/**
 * {@code ./dfra demo raster}: an operator's region becomes lanes, and robots search it.
 *
 * <pre>
 *   command line --RasterOptions--&gt; RasterSetup --MissionModes--&gt; Mission --At--&gt; LiveProgress
 *                                                                    |
 *                                    RasterReport &lt;--Scores-- Flight-'
 * </pre>
 */
@NullMarked
package org.dfra.app.demo.raster;

import org.jspecify.annotations.NullMarked;
