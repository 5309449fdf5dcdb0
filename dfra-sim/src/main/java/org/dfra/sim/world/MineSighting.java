package org.dfra.sim.world;

/**
 * A mine visible in a camera's image.
 *
 * @param mine its name
 * @param pixels number that show it
 * @param column of their centre, from the left edge, pixels
 * @param row of their centre, from the upper edge, pixels
 * @param distance of the mine's centre from the camera, metres
 */
public record MineSighting(String mine, int pixels, double column, double row, double distance) {}
