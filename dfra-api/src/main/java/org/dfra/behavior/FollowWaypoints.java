package org.dfra.behavior;

/** Drives a robot from place to place, by way of {@link GoToWaypoint}. */
public interface FollowWaypoints extends Behavior<PathGoal> {}
