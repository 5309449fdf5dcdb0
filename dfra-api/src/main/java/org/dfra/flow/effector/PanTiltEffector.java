package org.dfra.flow.effector;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * A head that rotates the devices mounted on it. Its own frame is that of the head and moves with
 * it: {@link org.dfra.geometry.Posable#localTransform} is the mount, then pan, then tilt.
 */
public interface PanTiltEffector extends Effector<PanTiltCommand> {

  /**
   * Where the head points.
   *
   * @throws org.dfra.module.NotReadyException if the unit has not reported yet, or the last report
   *     is too old
   */
  @Idempotent
  PanTiltState panTiltState() throws RemoteException;
}
