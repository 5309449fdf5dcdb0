package org.dfra.app.raster.monitor;

import java.io.IOException;
import java.util.List;
import org.dfra.sim.world.Collision;

/** A source of the robots' true poses while they search. */
public interface TruthSource {

  /**
   * Reads the poses since the last call.
   *
   * @throws IOException if there will be no more; the message names the cause
   */
  void readNew(TrueTrajectory way) throws IOException;

  /** Collisions of robots in order of time, except those of the last second. */
  List<Collision> collisions();
}
