/**
 * Outlines of objects seen from above, with collision tests and ray casting.
 *
 * <pre>
 *   PlanarShape: Disc, Polygon --&gt; StaticObstacle: a shape with a height --&gt; ObstacleIndex: search
 *                                                                               |            |
 *                                               OrientedRectangle: intersection test   RayCaster
 * </pre>
 *
 * <p>Coordinates are metres east and north in the world's frame, angles radians, 0 is east,
 * counter-clockwise is +. Nothing here depends on time or random numbers.
 */
@NullMarked
package org.dfra.sim.world.shape;

import org.jspecify.annotations.NullMarked;
