package org.dfra.sim.world;

import java.time.Instant;

/**
 * A collision of a robot.
 *
 * @param time of the step
 * @param robot that moved
 * @param other the obstacle or robot that it hit
 * @param speed relative, at the impact, metres per second
 * @param east position of the robot, metres
 * @param north position of the robot, metres
 */
public record Collision(
    Instant time, String robot, String other, double speed, double east, double north) {}
