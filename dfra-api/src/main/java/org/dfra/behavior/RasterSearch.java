package org.dfra.behavior;

/**
 * Drives a robot over a region in lanes until it has seen all of it. It remembers how far it is:
 * where it was at work when its process died, it goes on when it is back.
 */
public interface RasterSearch extends Script<RasterGoal> {}
