package org.dfra.river.loading;

import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Why classes were not loaded, for those who read objects through River, which only says that it
 * could not read them. Faults are kept for the thread on which they arise.
 */
public final class LoadingFaults {

  private static final ThreadLocal<@Nullable String> LAST = new ThreadLocal<>();

  private LoadingFaults() {}

  /** Reads something that River unmarshals on the caller's thread. */
  @FunctionalInterface
  public interface UnmarshalAction<E extends Exception> {
    void read() throws E;
  }

  /**
   * The sentence that says why a class was refused or could not be fetched meanwhile, and what to
   * do.
   *
   * @return empty where every class was loaded
   */
  public static <E extends Exception> Optional<String> during(UnmarshalAction<E> read) throws E {
    LAST.remove();
    try {
      read.read();
      return Optional.ofNullable(LAST.get());
    } finally {
      LAST.remove();
    }
  }

  static void add(Exception fault) {
    LAST.set(String.valueOf(fault.getMessage()));
  }
}
