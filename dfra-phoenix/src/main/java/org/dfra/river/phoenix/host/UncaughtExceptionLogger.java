package org.dfra.river.phoenix.host;

import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Logs the exceptions that end a thread of this process. The JVM itself would print their messages
 * unescaped, and another computer may have chosen them.
 */
public final class UncaughtExceptionLogger {

  private static final Logger LOG = LoggerFactory.getLogger(UncaughtExceptionLogger.class);

  private UncaughtExceptionLogger() {}

  /** Sets it for every thread without its own handler. */
  public static void install() {
    Thread.setDefaultUncaughtExceptionHandler(
        (thread, thrown) -> LOG.error("Thread {} ended.", thread.getName(), thrown));
  }
}
