package org.dfra.behavior;

/** A behaviour that is made of behaviours, one after the other. */
public interface Script<G extends Goal> extends Behavior<G> {}
