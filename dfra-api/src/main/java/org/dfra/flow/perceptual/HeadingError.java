package org.dfra.flow.perceptual;

import java.rmi.RemoteException;
import org.dfra.geometry.Leg;
import org.dfra.module.Idempotent;

/**
 * Tells how its robot stands to a line, from where the robot believes it is. It keeps no line:
 * whoever asks names it, so several behaviours may.
 */
public interface HeadingError extends PerceptualSchema {

  /**
   * How the robot stands to a line now. A line of no length is its end point only.
   *
   * @throws org.dfra.module.NotReadyException if there is no pose, or none that still counts
   */
  @Idempotent
  HeadingPercept towards(Leg leg) throws RemoteException;
}
