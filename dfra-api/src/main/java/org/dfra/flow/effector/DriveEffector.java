package org.dfra.flow.effector;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * Drives a robot over the ground.
 *
 * <p>A {@link DriveCommand.Velocity} is valid for a short time only: without a new one the wheels
 * stop within {@value #MAX_COMMAND_TIMEOUT} s, whatever failed in between.
 */
public interface DriveEffector extends Effector<DriveCommand> {

  /** Maximum seconds from the last velocity command until the wheels stop. */
  double MAX_COMMAND_TIMEOUT = 0.5;

  /** The last command to the drive, and its state. */
  @Idempotent
  DriveState driveState() throws RemoteException;
}
