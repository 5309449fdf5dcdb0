package org.dfra.sim.world;

import java.time.Instant;

/**
 * A robot ran into something.
 *
 * @param time when, to a step
 * @param robot who moved
 * @param other the obstacle or robot it ran into
 * @param speed at which the two met, metres per second
 * @param east where the robot was, metres
 * @param north where the robot was, metres
 */
public record Collision(
    Instant time, String robot, String other, double speed, double east, double north) {}
