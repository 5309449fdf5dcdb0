package org.dfra.river.lookup;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.logging.Filter;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.dfra.directory.RegistrationRefusedException;
import org.dfra.security.AccessRefusedException;
import org.jspecify.annotations.Nullable;
import org.slf4j.LoggerFactory;

/**
 * Logs once that a lookup service refuses a registration. River's join manager discards such a
 * lookup service, finds it again a second later, retries, and would log each failure.
 *
 * <p>Thread-safe.
 */
final class RefusalLogFilter implements Filter {

  private static final org.slf4j.Logger LOG = LoggerFactory.getLogger(RefusalLogFilter.class);

  /** The logger of River's join manager; without a strong reference it would lose its filter. */
  private static final Logger JOIN_MANAGER = Logger.getLogger("net.jini.lookup.JoinManager");

  private static final int REMEMBERED = 64;
  private static final int LONGEST_CHAIN = 10;

  private final @Nullable Filter next;

  /** Messages that were logged; limited to the newest. */
  private final Set<String> reported =
      Collections.synchronizedSet(
          Collections.newSetFromMap(
              new LinkedHashMap<String, Boolean>() {
                private static final long serialVersionUID = 1L;

                @Override
                protected boolean removeEldestEntry(Map.Entry<String, Boolean> eldest) {
                  return size() > REMEMBERED;
                }
              }));

  /**
   * @param next filters all other records; null if all are logged
   */
  RefusalLogFilter(@Nullable Filter next) {
    this.next = next;
  }

  /** Installs the filter for all join managers of this virtual machine. Idempotent. */
  static synchronized void install() {
    @Nullable Filter before = JOIN_MANAGER.getFilter();
    if (!(before instanceof RefusalLogFilter)) {
      JOIN_MANAGER.setFilter(new RefusalLogFilter(before));
    }
  }

  @Override
  public boolean isLoggable(LogRecord record) {
    @Nullable String refusal = refusal(record.getThrown());
    if (refusal == null) {
      return next == null || next.isLoggable(record);
    }
    if (reported.add(refusal)) {
      LOG.warn("A lookup service refuses a registration, which is tried again: {}.", refusal);
    }
    return false;
  }

  private static @Nullable String refusal(@Nullable Throwable thrown) {
    @Nullable Throwable at = thrown;
    for (int i = 0; at != null && i < LONGEST_CHAIN; i++) {
      if (at instanceof RegistrationRefusedException || at instanceof AccessRefusedException) {
        return String.valueOf(at.getMessage());
      }
      at = at.getCause();
    }
    return null;
  }
}
