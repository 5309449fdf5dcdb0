package org.dfra.flow.perceptual;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** Finds mines on the ground by how they look and how warm they are. */
public interface MineDetector extends PerceptualSchema {

  /**
   * All it has taken for mines so far.
   *
   * @throws org.dfra.module.NotReadyException if it has not seen anything yet
   */
  @Idempotent
  MinePercept mines() throws RemoteException;
}
