package org.dfra.behaviors.waypoint;

import java.rmi.RemoteException;
import java.time.Duration;
import org.dfra.core.behavior.DriveInterlock;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.lease.LeaseRefusedException;
import org.jspecify.annotations.Nullable;

/**
 * A robot's wheels in a behaviour's hands. It becomes their commander at the first velocity and
 * lets go of them when it rests; then they stand. It never releases their brake: see {@link
 * DriveInterlock}. Confined to the behaviour's turns.
 */
final class LeasedDrive {

  private static final Duration LEASE = Duration.ofSeconds(2);

  private final DriveInterlock interlock;
  private @Nullable DriveEffector commanded;
  private @Nullable CommandLease lease;

  LeasedDrive(DriveInterlock interlock) {
    this.interlock = interlock;
  }

  /** Has them turn so until the next velocity, which must come soon. */
  void setVelocity(Velocity velocity) throws RemoteException, LeaseRefusedException {
    CommandLease held = lease;
    DriveEffector wheels = commanded;
    if (held == null || wheels == null) {
      wheels = interlock.drive().resolve();
      held = wheels.acquireCommandLease(LEASE);
      commanded = wheels;
      lease = held;
      interlock.requireNotStoppedSince(wheels);
    }
    try {
      wheels.execute(
          held.key(), velocity); // also by a lease that is over: only they know why it is
    } catch (CommandRefusedException e) {
      release();
      throw e;
    }
  }

  /** Lets go of them. */
  void release() {
    CommandLease held = lease;
    lease = null;
    commanded = null;
    if (held != null) {
      held.close();
    }
  }
}
