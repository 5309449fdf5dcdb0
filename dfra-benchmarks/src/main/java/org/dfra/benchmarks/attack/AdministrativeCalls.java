package org.dfra.benchmarks.attack;

import org.dfra.module.LogLevel;
import org.dfra.river.remote.effector.RemoteDriveEffector;

/**
 * Makes calls that only the robot's own computer may make: sets a parameter and the log level, and
 * releases an emergency stop.
 */
final class AdministrativeCalls extends AttackTask {

  /** Called by {@code TaskMain} by reflection. */
  public AdministrativeCalls() {}

  @Override
  protected void attack(Target target) throws Exception {
    RemoteDriveEffector drive = target.remoteDrive();
    while (!isStopping()) {
      var unused =
          attempt(
              () -> {
                drive.setParameter("max_speed", "0.9");
                return true;
              });
      var unusedEither =
          attempt(
              () -> {
                drive.setLogLevel(LogLevel.WARN);
                return true;
              });
      var unusedToo = attempt(() -> drive.releaseEmergencyStop("attacker"));
    }
  }
}
