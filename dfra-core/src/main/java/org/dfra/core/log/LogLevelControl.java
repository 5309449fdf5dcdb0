package org.dfra.core.log;

import java.util.ServiceLoader;
import org.dfra.module.LogLevel;

/**
 * Sets log levels at run time. SLF4J, the modules' logging API, can only query them. The module
 * that provides a logging library also provides an implementation of this interface, named in
 * {@code META-INF/services}.
 */
public interface LogLevelControl {

  /**
   * The level of a logger, its own or inherited.
   *
   * @param logger its name, e.g. {@code dfra.atrv1.gps_front}
   */
  LogLevel level(String logger);

  /** Sets the level of a logger. */
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
                        + " is on the class path; add dfra-cli, which has one for Logback"));
  }
}
