package org.dfra.app.raster;

/**
 * An event of a robot during the search, such as that a process was killed.
 *
 * @param time seconds since the search began
 * @param robot the robot's name
 * @param what the event, in a few words
 */
public record MissionEvent(double time, String robot, String what) {}
