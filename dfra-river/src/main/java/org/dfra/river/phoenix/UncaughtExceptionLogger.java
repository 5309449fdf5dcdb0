package org.dfra.river.phoenix;

import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Exceptions that end a thread of this process go to the log. The JVM itself would write their
 * messages as they are, and another computer may have chosen them.
 */
final class UncaughtExceptionLogger {

  private static final Logger LOG = LoggerFactory.getLogger(UncaughtExceptionLogger.class);

  private UncaughtExceptionLogger() {}

  /** From now on, in every thread that has no handler of its own. */
  static void install() {
    Thread.setDefaultUncaughtExceptionHandler(
        (thread, thrown) -> LOG.error("Thread {} ended.", thread.getName(), thrown));
  }
}
