package org.dfra.sim.world;

/**
 * A mine that is in a camera's picture.
 *
 * @param mine its name
 * @param pixels that show it
 * @param column of their middle, from the left edge, pixels
 * @param row of their middle, from the upper edge, pixels
 * @param distance of the mine's middle from the camera, metres
 */
public record MineSighting(String mine, int pixels, double column, double row, double distance) {}
