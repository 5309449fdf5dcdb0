package org.dfra.behavior;

/** Drives a robot along several waypoints by using {@link GoToWaypoint}. */
public interface FollowWaypoints extends Behavior<PathGoal> {}
