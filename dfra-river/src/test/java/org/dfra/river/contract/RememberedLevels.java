package org.dfra.river.contract;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.core.log.LogLevelControl;
import org.dfra.module.LogLevel;

/** Levels of loggers that do not log. */
public final class RememberedLevels implements LogLevelControl {

  private static final Map<String, LogLevel> LEVELS = new ConcurrentHashMap<>();

  @Override
  public LogLevel level(String logger) {
    return LEVELS.getOrDefault(logger, LogLevel.INFO);
  }

  @Override
  public void set(String logger, LogLevel level) {
    LEVELS.put(logger, level);
  }
}
