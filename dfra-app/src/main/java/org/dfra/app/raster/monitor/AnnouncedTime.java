package org.dfra.app.raster.monitor;

import org.dfra.core.time.RobotTime;
import org.jspecify.annotations.Nullable;

/**
 * The robots' time of a search, which this virtual machine lives by until it is closed, and tells
 * those that it starts. There can be only one at a time.
 */
public final class AnnouncedTime implements AutoCloseable {

  private final @Nullable String before = System.getProperty(RobotTime.PROPERTY);

  /** From now on it is this one; see {@link RobotTime}. */
  public void set(String time) {
    System.setProperty(RobotTime.PROPERTY, time);
  }

  /** It is again what it was before. */
  @Override
  public void close() {
    if (before == null) {
      System.clearProperty(RobotTime.PROPERTY);
    } else {
      System.setProperty(RobotTime.PROPERTY, before);
    }
  }
}
