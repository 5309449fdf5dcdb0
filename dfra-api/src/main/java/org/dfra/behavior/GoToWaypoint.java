package org.dfra.behavior;

/** Drives a robot along a line to its end, around what is in the way. */
public interface GoToWaypoint extends Behavior<LegGoal> {}
