package org.dfra.flow.perceptual;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * Follows the other robots of the team by the poses that they tell: how far they are, how far their
 * clocks are ahead, and for how long they could not be heard.
 */
public interface TeamTracker extends PerceptualSchema {

  /**
   * What is known of the others; nobody, where there is none.
   *
   * @throws org.dfra.module.NotReadyException if its own robot does not know where it is
   */
  @Idempotent
  TeamPositions team() throws RemoteException;
}
