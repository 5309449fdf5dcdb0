package org.dfra.flow.perceptual;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** Tells where its robot is, from all that its robot has to say of that. */
public interface PositionEstimator extends PerceptualSchema {

  /**
   * The last estimate.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or none that still counts
   */
  @Idempotent
  PoseEstimate estimate() throws RemoteException;
}
