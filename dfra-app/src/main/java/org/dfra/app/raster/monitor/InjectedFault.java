package org.dfra.app.raster.monitor;

/**
 * A fault injected during the search. Confined to the thread that monitors the search.
 *
 * @param <R> the runtime of a robot
 */
public interface InjectedFault<R> extends AutoCloseable {

  /** No fault. */
  static <R> InjectedFault<R> none() {
    return new InjectedFault<>() {
      @Override
      public void update(MissionContext<R> now) {}

      @Override
      public boolean hasStarted() {
        return false;
      }

      @Override
      public boolean isOver() {
        return true;
      }
    };
  }

  /**
   * Checks whether to inject the fault, or its consequences; called ten times a second until it is
   * over. Returns quickly.
   */
  void update(MissionContext<R> now) throws Exception;

  /** Whether the fault has been injected. */
  boolean hasStarted();

  /** Whether the fault and its consequences are over, or it cannot occur any more. */
  boolean isOver();

  @Override
  default void close() {}
}
