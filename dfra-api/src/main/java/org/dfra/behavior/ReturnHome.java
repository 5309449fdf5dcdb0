package org.dfra.behavior;

/** Drives a robot back to where it began. */
public interface ReturnHome extends Behavior<HomeGoal> {}
