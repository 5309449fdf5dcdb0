package org.dfra.behavior;

/**
 * Drives a robot over a region in lanes until it has observed all of it. It stores its progress: if
 * its process dies during a search, the search resumes after the restart.
 */
public interface RasterSearch extends Script<RasterGoal> {}
