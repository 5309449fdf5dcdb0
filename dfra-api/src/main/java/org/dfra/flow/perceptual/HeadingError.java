package org.dfra.flow.perceptual;

import java.rmi.RemoteException;
import org.dfra.geometry.Leg;
import org.dfra.module.Idempotent;

/**
 * Computes the robot's position and heading relative to a line, from its pose estimate. It stores
 * no line: the caller passes it, so several behaviours can share the module.
 */
public interface HeadingError extends PerceptualSchema {

  /**
   * The robot's current position and heading relative to a line. A line of length zero is its end
   * point only.
   *
   * @throws org.dfra.module.NotReadyException if there is no pose, or it is too old
   */
  @Idempotent
  HeadingPercept towards(Leg leg) throws RemoteException;
}
