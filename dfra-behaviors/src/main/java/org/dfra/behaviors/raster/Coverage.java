package org.dfra.behaviors.raster;

/**
 * How much of a region was seen.
 *
 * @param share of the region's area that was seen at all, 0 to 1
 * @param overlap share of the region's area that was seen on two passes or more, 0 to 1; a pass
 *     over a point ends when the robot has driven a swath's width without seeing it
 * @param cellSize side of the squares that were counted, metres; the shares are as exact as an edge
 *     of what was seen counted in such squares
 */
public record Coverage(double share, double overlap, double cellSize) {}
