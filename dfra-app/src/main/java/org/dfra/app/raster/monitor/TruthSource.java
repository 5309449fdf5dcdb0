package org.dfra.app.raster.monitor;

import java.io.IOException;
import java.util.List;
import org.dfra.sim.world.Collision;

/** Tells where robots truly are while they search. */
public interface TruthSource {

  /**
   * Tells what is new since the last time.
   *
   * @throws IOException if nothing will be new any more; the message says why
   */
  void readNew(TrueTrajectory way) throws IOException;

  /** What robots ran into, as they did, up to a second ago. */
  List<Collision> collisions();
}
