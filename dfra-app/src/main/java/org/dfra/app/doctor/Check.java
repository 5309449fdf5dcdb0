package org.dfra.app.doctor;

import java.util.List;

/** Looks at one thing. It changes nothing, and ends within three seconds. */
interface Check {

  /** What it looks at. */
  Subject subject();

  /** Looks. */
  List<Finding> run() throws InterruptedException;
}
