package org.dfra.flow.effector;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * What moves a robot over the ground.
 *
 * <p>A {@link DriveCommand.Velocity} holds for a short while only: wheels that hear of no other
 * stand still within {@value #LONGEST_SILENCE} s of it, whatever died in between.
 */
public interface DriveEffector extends Effector<DriveCommand> {

  /** Seconds after the last velocity within which the wheels stand. */
  double LONGEST_SILENCE = 0.5;

  /** What the drive was last told, and what it does about it. */
  @Idempotent
  DriveState drive() throws RemoteException;
}
