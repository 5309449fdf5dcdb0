package org.dfra.core.log;

import java.util.ServiceLoader;
import org.dfra.module.LogLevel;

/**
 * Sets how much is logged, while it is. SLF4J, which modules log by, can only ask. Whoever brings a
 * logging library brings an implementation of this with it, named in {@code META-INF/services}.
 */
public interface LogLevelControl {

  /**
   * How much a logger writes, itself or by inheritance.
   *
   * @param logger its name, e.g. {@code dfra.atrv1.gps_front}
   */
  LogLevel level(String logger);

  /** Sets how much a logger writes, from now on. */
  void set(String logger, LogLevel level);

  /**
   * The implementation on the class path.
   *
   * @throws IllegalStateException if there is none
   */
  static LogLevelControl service() {
    return ServiceLoader.load(LogLevelControl.class, LogLevelControl.class.getClassLoader())
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalStateException(
                    "log levels cannot be set here: no "
                        + LogLevelControl.class.getName()
                        + " is on the class path; add dfra-app, which has one for Logback"));
  }
}
