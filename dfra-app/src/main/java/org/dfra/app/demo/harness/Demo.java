package org.dfra.app.demo.harness;

/** A demonstration. */
public interface Demo {

  /**
   * Runs it from beginning to end and clears everything away.
   *
   * @return whether every step went well; what did not has been told
   */
  boolean run();
}
