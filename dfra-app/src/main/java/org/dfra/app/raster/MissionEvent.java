package org.dfra.app.raster;

/**
 * Something that happened to a robot on the way, such as that a process was killed.
 *
 * @param time seconds since the search began
 * @param robot the robot's name
 * @param what happened, in a few words
 */
public record MissionEvent(double time, String robot, String what) {}
