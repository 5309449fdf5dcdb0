package org.dfra.flow.perceptual;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * Computes the clearance around a robot from its range sensor. It filters over several scans, so
 * that an artefact in a single scan (dust, a bump that tilts the beams into the ground) is ignored.
 */
public interface RangeFilter extends PerceptualSchema {

  /**
   * The clearance of the last scans.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or it is too old
   */
  @Idempotent
  Clearance clearance() throws RemoteException;
}
