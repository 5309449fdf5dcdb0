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
 * A drive leased by a behaviour. It acquires the command lease at the first velocity and releases
 * it when the behaviour is suspended; then the wheels stop. It never releases their brake: see
 * {@link DriveInterlock}. Confined to the behaviour's cycles.
 */
final class LeasedDrive {

  private static final Duration LEASE = Duration.ofSeconds(2);

  private final DriveInterlock interlock;
  private @Nullable DriveEffector commanded;
  private @Nullable CommandLease lease;

  LeasedDrive(DriveInterlock interlock) {
    this.interlock = interlock;
  }

  /** Commands a velocity, valid until the next one or the command timeout. */
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
          held.key(), velocity); // also with an expired lease: only the effector knows the reason
    } catch (CommandRefusedException e) {
      release();
      throw e;
    }
  }

  /** Releases the command lease. */
  void release() {
    CommandLease held = lease;
    lease = null;
    commanded = null;
    if (held != null) {
      held.close();
    }
  }
}
