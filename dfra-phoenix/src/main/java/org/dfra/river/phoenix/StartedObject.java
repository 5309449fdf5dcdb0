package org.dfra.river.phoenix;

/**
 * An activatable object that its group starts when its constructor has returned. So no other thread
 * sees an object whose constructor still runs. An object that is not of this kind starts in its
 * constructor, as River's services do.
 */
public interface StartedObject {

  /**
   * Starts and exports the object. Called once, by the thread that constructed it.
   *
   * @throws Exception if it cannot be started; then it has undone everything
   */
  void start() throws Exception;
}
