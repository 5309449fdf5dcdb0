package org.dfra.drive;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.testing.InteractiveProcess;

/**
 * Drives a robot straight on, twenty commands a second, until it is closed or killed; in the test's
 * virtual machine or as a process of its own.
 */
public final class Commander implements AutoCloseable {

  private static final long PERIOD_MILLIS = 50;

  private final DriveEffector drive;
  private final CommandLease lease;
  private final ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor();
  private final ScheduledFuture<?> driving;

  /** Takes command, releases the brake and drives. */
  public Commander(DriveEffector drive, Duration duration, Velocity velocity) throws Exception {
    this.drive = drive;
    this.lease = drive.acquireCommandLease(duration);
    try {
      drive.execute(lease.key(), new Brake(false));
    } catch (RemoteException | RuntimeException e) {
      close();
      throw e;
    }
    this.driving =
        thread.scheduleAtFixedRate(
            () -> command(velocity), 0, PERIOD_MILLIS, TimeUnit.MILLISECONDS);
  }

  private void command(Velocity velocity) {
    try {
      drive.execute(lease.key(), velocity);
    } catch (RemoteException e) {
      throw new IllegalStateException("the drive does not answer", e); // ends the driving
    }
  }

  public CommandLease lease() {
    return lease;
  }

  /** Whether it commands no more, since its command was refused or not answered. */
  public boolean hasGivenUp() {
    return driving.isDone();
  }

  @Override
  public void close() {
    thread.shutdownNow();
    lease.close();
  }

  /**
   * As a process of its own. It says that it commands, and why it ended.
   *
   * @param args the lookup service's locator, and the lease in milliseconds
   */
  public static void main(String[] args) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    try (JiniModuleDirectory directory =
        new JiniModuleDirectory("127.0.0.1", List.of(), List.of(args[0]))) {
      DriveEffector drive =
          directory
              .findFirst(ModuleQuery.of(DriveEffector.class), Duration.ofSeconds(30))
              .orElseThrow()
              .module();
      try (Commander commander =
          new Commander(drive, Duration.ofMillis(Long.parseLong(args[1])), new Velocity(1, 0))) {
        System.out.println(InteractiveProcess.RESPONSE_PREFIX + "commanding");
        commander.driving.get();
      } catch (ExecutionException e) {
        System.out.println(InteractiveProcess.RESPONSE_PREFIX + "ended: " + e.getCause());
      }
    }
  }
}
