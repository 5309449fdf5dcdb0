package org.dfra.app.demo.harness;

/** A demonstration. */
public interface Demo {

  /**
   * Runs it from beginning to end and cleans up.
   *
   * @return whether every step succeeded; failures have been reported
   */
  boolean run();
}
