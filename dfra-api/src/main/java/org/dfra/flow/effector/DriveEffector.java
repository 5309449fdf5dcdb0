package org.dfra.flow.effector;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * What moves a robot over the ground.
 *
 * <p>A {@link DriveCommand.Velocity} holds for a short while only: wheels that hear of no other
 * stand still within {@value #MAX_COMMAND_TIMEOUT} s of it, whatever died in between.
 */
public interface DriveEffector extends Effector<DriveCommand> {

  /** Seconds after the last velocity within which the wheels stand. */
  double MAX_COMMAND_TIMEOUT = 0.5;

  /** What the drive was last told, and what it does about it. */
  @Idempotent
  DriveState driveState() throws RemoteException;
}
