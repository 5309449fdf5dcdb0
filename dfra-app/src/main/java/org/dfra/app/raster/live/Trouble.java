package org.dfra.app.raster.live;

/**
 * Something that goes wrong on the way. Confined to the thread that watches the search.
 *
 * @param <R> what runs a robot
 */
public interface Trouble<R> extends AutoCloseable {

  /** One that there is not. */
  static <R> Trouble<R> none() {
    return new Trouble<>() {
      @Override
      public void look(Scene<R> now) {}

      @Override
      public boolean hasBegun() {
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
  void look(Scene<R> now) throws Exception;

  /** Whether something has gone wrong, or did. */
  boolean hasBegun();

  /** Whether it has happened and its consequences were seen, or it can happen no more. */
  boolean isOver();

  @Override
  default void close() {}
}
