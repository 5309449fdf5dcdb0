package org.dfra.directory;

/** An exception of a failed remote call that states whether the call may have been executed. */
public interface ExecutionCertainty {

  /** Whether the module may have executed the call; false means it certainly has not. */
  boolean mayHaveRun();
}
