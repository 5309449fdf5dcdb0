package org.dfra.flow.perceptual;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * Tracks the other robots of the team by the poses that they publish: their distance, their clock
 * offset, and how long no message was received from them.
 */
public interface TeamTracker extends PerceptualSchema {

  /**
   * The known teammates; empty if there are none.
   *
   * @throws org.dfra.module.NotReadyException if the pose of its own robot is unknown
   */
  @Idempotent
  TeamPositions team() throws RemoteException;
}
