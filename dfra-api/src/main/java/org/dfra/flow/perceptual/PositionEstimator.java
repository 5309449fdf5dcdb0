package org.dfra.flow.perceptual;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** Estimates the pose of its robot by fusing the readings of its sensors. */
public interface PositionEstimator extends PerceptualSchema {

  /**
   * The last estimate.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or it is too old
   */
  @Idempotent
  PoseEstimate estimate() throws RemoteException;
}
