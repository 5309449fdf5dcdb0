package org.dfra.behavior;

/** Drives a robot back to its start position. */
public interface ReturnHome extends Behavior<HomeGoal> {}
