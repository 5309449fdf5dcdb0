package org.dfra.examples.mission.monitor;

import org.dfra.core.time.RobotTime;
import org.jspecify.annotations.Nullable;

/**
 * The time of the robots in a search. This JVM uses it until this is closed, and passes it to the
 * processes that it starts. There can be only one at a time.
 */
public final class AnnouncedTime implements AutoCloseable {

  private final @Nullable String before = System.getProperty(RobotTime.PROPERTY);

  /** Sets the time; see {@link RobotTime}. */
  public void set(String time) {
    System.setProperty(RobotTime.PROPERTY, time);
  }

  /** Restores the previous value. */
  @Override
  public void close() {
    if (before == null) {
      System.clearProperty(RobotTime.PROPERTY);
    } else {
      System.setProperty(RobotTime.PROPERTY, before);
    }
  }
}
