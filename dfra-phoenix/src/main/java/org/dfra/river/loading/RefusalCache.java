package org.dfra.river.loading;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Remembers refusals for a while, so that a client that offers the same code repeatedly causes
 * neither downloads nor log lines. Thread-safe.
 */
final class RefusalCache {

  private static final int MOST = 256;
  private static final long KEPT_NANOS = TimeUnit.SECONDS.toNanos(10);

  private final LongSupplier nanoTime;
  private final Map<String, Refusal> refused =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Refusal> eldest) {
          return size() > MOST;
        }
      }; // guarded by itself

  RefusalCache(LongSupplier nanoTime) {
    this.nanoTime = nanoTime;
  }

  private record Refusal(String message, long end) {}

  /**
   * @return whether the refusal is new
   */
  boolean add(String codebase, CodeRefusedException reason) {
    String message = String.valueOf(reason.getMessage());
    long now = nanoTime.getAsLong();
    synchronized (refused) {
      Refusal before = refused.remove(codebase);
      refused.put(codebase, new Refusal(message, now + KEPT_NANOS));
      return before == null || before.end() - now <= 0;
    }
  }

  /**
   * @throws CodeRefusedException if the codebase was refused recently
   */
  void check(String codebase) {
    synchronized (refused) {
      Refusal before = refused.get(codebase);
      if (before != null && before.end() - nanoTime.getAsLong() > 0) {
        throw new CodeRefusedException(before.message());
      }
    }
  }
}
