package org.dfra.flow.effector;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * A head that turns what is mounted on it. Its own frame is that of the head and moves with it:
 * {@link org.dfra.geometry.Posable#localTransform} is the mount, then pan, then tilt.
 */
public interface PanTiltEffector extends Effector<PanTiltCommand> {

  /**
   * Where the head points.
   *
   * @throws org.dfra.module.NotReadyException if the unit has not told yet, or too long ago
   */
  @Idempotent
  PanTiltState panTiltState() throws RemoteException;
}
