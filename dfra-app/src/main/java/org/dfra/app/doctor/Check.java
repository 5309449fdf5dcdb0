package org.dfra.app.doctor;

import java.util.List;

/** Checks one aspect. It changes nothing, and ends within three seconds. */
interface Check {

  /** The checked subject. */
  Subject subject();

  /** Runs the check. */
  List<Finding> run() throws InterruptedException;
}
