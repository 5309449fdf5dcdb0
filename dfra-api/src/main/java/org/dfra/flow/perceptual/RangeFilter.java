package org.dfra.flow.perceptual;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * Tells the room around a robot from its range sensor, several scans at a time, so that what only
 * one of them shows (dust, a bump that tilts the beams into the ground) does not count.
 */
public interface RangeFilter extends PerceptualSchema {

  /**
   * The room as the last scans showed it.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or none that still counts
   */
  @Idempotent
  Clearance clearance() throws RemoteException;
}
