package org.dfra.flow.perceptual;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** Detects mines on the ground in visible and thermal images. */
public interface MineDetector extends PerceptualSchema {

  /**
   * All mines detected so far.
   *
   * @throws org.dfra.module.NotReadyException if it has not processed an image yet
   */
  @Idempotent
  MinePercept mines() throws RemoteException;
}
