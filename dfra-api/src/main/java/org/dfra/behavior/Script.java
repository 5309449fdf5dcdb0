package org.dfra.behavior;

/** A behaviour that executes other behaviours in sequence. */
public interface Script<G extends Goal> extends Behavior<G> {}
