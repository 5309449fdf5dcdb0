package org.dfra.behaviors.raster;

/**
 * Coverage of a region.
 *
 * @param share of the region's area that was seen at least once, 0 to 1
 * @param overlap share of the region's area that was seen on two passes or more, 0 to 1; a pass
 *     over a point ends when the robot has driven a swath's width without seeing it
 * @param cellSize side of the squares that were counted, metres; the error of the shares is about
 *     one square along the edge of the seen area
 */
public record Coverage(double share, double overlap, double cellSize) {}
