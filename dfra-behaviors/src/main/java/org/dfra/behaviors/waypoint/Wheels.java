package org.dfra.behaviors.waypoint;

import java.rmi.RemoteException;
import java.time.Duration;
import org.dfra.core.module.Needed;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.lease.LeaseRefusedException;
import org.jspecify.annotations.Nullable;

/**
 * A robot's wheels in a behaviour's hands. It becomes their commander at the first velocity and
 * lets go of them when it rests; then they stand. Confined to the behaviour's turns.
 */
final class Wheels {

  private static final Duration LEASE = Duration.ofSeconds(2);

  private final Needed<DriveEffector> drive;
  private @Nullable DriveEffector commanded;
  private @Nullable CommandLease lease;

  Wheels(Needed<DriveEffector> drive) {
    this.drive = drive;
  }

  /** Has them turn so until the next velocity, which must come soon. */
  void turn(Velocity velocity) throws RemoteException, LeaseRefusedException {
    obey(velocity);
  }

  private void obey(DriveCommand command) throws RemoteException, LeaseRefusedException {
    CommandLease held = lease;
    DriveEffector wheels = commanded;
    if (held == null || wheels == null) {
      wheels = drive.now();
      held = wheels.command(LEASE);
      commanded = wheels;
      lease = held;
      wheels.obey(held.key(), new Brake(false));
    }
    try {
      wheels.obey(held.key(), command); // also by a lease that is over: only they know why it is
    } catch (CommandRefusedException e) {
      rest();
      throw e;
    }
  }

  /** Lets go of them. */
  void rest() {
    CommandLease held = lease;
    lease = null;
    commanded = null;
    if (held != null) {
      held.close();
    }
  }
}
