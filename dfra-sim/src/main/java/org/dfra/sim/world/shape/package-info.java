/**
 * The outlines of things seen from above, and what can be asked of them: whether two touch, and how
 * far a beam gets.
 *
 * <pre>
 *   Outline: Disc, Polygon --&gt; Solid, an outline with a height --&gt; ObstacleIndex: which are near?
 *                                                                    |            |
 *                                                    Footprint: touches it?   RayCaster: sees it?
 * </pre>
 *
 * <p>Coordinates are metres east and north in the world's frame, angles radians, 0 is east,
 * counter-clockwise is +. Nothing here knows time or chance.
 */
@NullMarked
package org.dfra.sim.world.shape;

import org.jspecify.annotations.NullMarked;
