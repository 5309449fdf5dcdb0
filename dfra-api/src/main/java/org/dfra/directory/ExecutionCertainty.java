package org.dfra.directory;

/** A failed remote call's exception that knows whether the call may have run nevertheless. */
public interface ExecutionCertainty {

  /** Whether the module may have carried out the call; false means it certainly has not. */
  boolean mayHaveRun();
}
