package org.dfra.river.loading;

import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Reports why classes were not loaded, for code that reads objects through River. River itself only
 * reports that it could not read them. Faults are recorded for the thread in which they occur.
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
   * The message with the reason why a class was refused or could not be fetched meanwhile, and the
   * remedy.
   *
   * @return empty if every class was loaded
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
