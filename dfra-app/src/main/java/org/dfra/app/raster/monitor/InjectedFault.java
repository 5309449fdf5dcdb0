package org.dfra.app.raster.monitor;

/**
 * Something that goes wrong on the way. Confined to the thread that watches the search.
 *
 * @param <R> what runs a robot
 */
public interface InjectedFault<R> extends AutoCloseable {

  /** One that there is not. */
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
   * Looks whether it is time, or what has become of it; ten times a second until it is over.
   * Returns soon.
   */
  void update(MissionContext<R> now) throws Exception;

  /** Whether something has gone wrong, or did. */
  boolean hasStarted();

  /** Whether it has happened and its consequences were seen, or it can happen no more. */
  boolean isOver();

  @Override
  default void close() {}
}
