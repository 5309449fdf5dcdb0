package org.dfra.river.phoenix;

/**
 * An activatable object that is not ready right after its construction: a module, which must find
 * its device first. Any other object counts as ready when its constructor has returned.
 */
public interface ReadinessSource {

  /** Whether the object is ready now. Must not block. */
  boolean isReady();
}
