package org.dfra.app.doctor;

import java.util.List;

/**
 * Which Java runs DFRA.
 *
 * @param feature its feature number, such as 17
 * @param version as it tells it itself
 * @param home its folder
 */
record JavaCheck(int feature, String version, String home) implements Check {

  private static final int LEAST = 17;

  /** The Java that runs this. */
  static JavaCheck ofThisProcess() {
    return new JavaCheck(
        Runtime.version().feature(),
        System.getProperty("java.version"),
        System.getProperty("java.home"));
  }

  @Override
  public Subject subject() {
    return Subject.JAVA;
  }

  @Override
  public List<Finding> examine() {
    String what = "Java " + version + " at " + home;
    return List.of(
        feature >= LEAST
            ? Finding.ok(subject(), what)
            : Finding.fail(
                subject(),
                what + " is older than " + LEAST,
                "Install Java " + LEAST + " or newer, and name its folder in JAVA_HOME."));
  }
}
