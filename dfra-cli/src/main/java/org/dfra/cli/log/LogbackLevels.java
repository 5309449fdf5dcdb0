package org.dfra.cli.log;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import org.dfra.core.log.LogLevelControl;
import org.dfra.module.LogLevel;
import org.slf4j.LoggerFactory;

/** Sets the log levels of Logback, the logging library of this application. */
public final class LogbackLevels implements LogLevelControl {

  @Override
  public LogLevel level(String logger) {
    int level = logger(logger).getEffectiveLevel().toInt();
    LogLevel found = LogLevel.TRACE;
    for (LogLevel candidate : LogLevel.values()) {
      if (Level.toLevel(candidate.name()).toInt() <= level) {
        found = candidate;
      }
    }
    return found;
  }

  @Override
  public void set(String logger, LogLevel level) {
    logger(logger).setLevel(Level.toLevel(level.name()));
  }

  private static Logger logger(String name) {
    if (LoggerFactory.getLogger(name) instanceof Logger logger) {
      return logger;
    }
    throw new IllegalStateException(
        "log levels cannot be set: the class path holds another logging library before Logback");
  }
}
