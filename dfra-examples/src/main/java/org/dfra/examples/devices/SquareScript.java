package org.dfra.examples.devices;

import java.io.IOException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.sensor.Odometry;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.NotReadyException;
import org.jspecify.annotations.Nullable;

/**
 * Drives a square: straight by odometry, around the corner by gyro. It sends a drive command for
 * each odometry reading. When readings stop or the drive does not respond, it waits for them,
 * acquires a new command lease, and continues on the same side.
 */
final class SquareScript {

  /** Length of a side, metres. */
  static final double SIDE = 4;

  private static final int SIDES = 4;
  private static final double SPEED = 0.8; // m/s
  private static final double SLOWEST = 0.1; // m/s
  private static final double YAW_RATE = 0.8; // rad/s
  private static final double SLOWEST_TURN = 0.15; // rad/s
  private static final double TURNED = 0.02; // rad
  private static final Duration LEASE = Duration.ofSeconds(3);
  private static final Duration SILENCE = Duration.ofMillis(500);
  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;

  /** Is notified of the progress. */
  @FunctionalInterface
  interface Progress {

    /**
     * @param side counted from 0
     * @param metres driven on this side so far
     */
    void on(int side, double metres) throws Exception;
  }

  private final DriveEffector drive;
  private final ReadingRecorder<Odometry> odometry;
  private final ContinuousOdometry track;
  private final Heading heading;
  private final Progress progress;

  private @Nullable CommandLease lease;
  private Instant lastCommand = Instant.MIN;
  private boolean isBegun; // whether the brake was released, once
  private int resumptions;
  private long seen;

  SquareScript(
      DriveEffector drive,
      ReadingRecorder<Odometry> odometry,
      ContinuousOdometry track,
      Heading heading,
      Progress progress) {
    this.drive = drive;
    this.odometry = odometry;
    this.track = track;
    this.heading = heading;
    this.progress = progress;
  }

  /** Drives the whole square. */
  void run() throws Exception {
    takeCommand();
    try {
      for (int side = 0; side < SIDES; side++) {
        straight(side, side * Math.PI / 2);
        corner((side + 1) * Math.PI / 2);
      }
    } finally {
      if (lease != null) {
        lease.close();
      }
    }
  }

  /** When the last command that the drive accepted was sent. */
  Instant lastCommand() {
    return lastCommand;
  }

  /** How often it had to acquire a new command lease. */
  int resumptions() {
    return resumptions;
  }

  private void straight(int side, double course) throws Exception {
    @Nullable Odometry from = null;
    while (true) {
      @Nullable Odometry now = nextPose();
      if (now == null) {
        resume();
        continue;
      }
      from = from == null ? now : from;
      double metres = Math.hypot(now.x() - from.x(), now.y() - from.y());
      double left = SIDE - metres;
      if (left <= 0) {
        command(Velocity.ZERO);
        return;
      }
      double speed = Math.max(SLOWEST, Math.min(SPEED, left));
      double turnRate = Math.max(-0.5, Math.min(0.5, 1.5 * (course - heading.heading())));
      if (command(new Velocity(speed, turnRate))) {
        progress.on(side, metres);
      }
    }
  }

  private void corner(double course) throws Exception {
    while (true) {
      if (nextPose() == null) {
        resume();
        continue;
      }
      double left = course - heading.heading();
      if (Math.abs(left) < TURNED) {
        command(Velocity.ZERO);
        return;
      }
      double rate = Math.max(SLOWEST_TURN, Math.min(YAW_RATE, 1.5 * Math.abs(left)));
      command(new Velocity(0, Math.copySign(rate, left)));
    }
  }

  /** The robot's pose at the next odometry reading; null on a timeout. */
  private @Nullable Odometry nextPose() throws InterruptedException {
    @Nullable Odometry counted = odometry.next(seen, SILENCE);
    seen = odometry.count();
    return counted == null ? null : track.pose();
  }

  /** Whether the drive has accepted the command. */
  private boolean command(Velocity velocity) throws Exception {
    CommandLease held = lease;
    if (held == null) {
      return false;
    }
    try {
      Instant now = Instant.now();
      drive.execute(held.key(), velocity);
      lastCommand = now;
      return true;
    } catch (BrakeEngagedException e) { // by an operator, or by a controller that was switched off
      throw e;
    } catch (CommandRefusedException | NotReadyException | RemoteException e) {
      resume();
      return false;
    }
  }

  /** The drive or its odometry was lost: waits for it and acquires a new command lease. */
  private void resume() throws Exception {
    if (lease != null) {
      lease.close();
      lease = null;
    }
    takeCommand();
    resumptions++;
  }

  private void takeCommand() throws IOException, InterruptedException {
    long end = System.nanoTime() + PATIENCE.toNanos();
    Exception why = null;
    while (System.nanoTime() - end < 0) {
      try {
        if (drive.awaitReadiness(Duration.ofSeconds(1)).serves()) {
          CommandLease taken = drive.acquireCommandLease(LEASE);
          lease = taken;
          if (!isBegun) { // a brake that is set later stays set
            drive.execute(taken.key(), new Brake(false)); // the field is level
            isBegun = true;
          }
          return;
        }
      } catch (LeaseRefusedException
          | CommandRefusedException
          | NotReadyException
          | RemoteException e) {
        why = e;
        odometry.next(odometry.count(), SILENCE); // it returns together with the drive
      }
    }
    throw new IOException("the script could not acquire the drive's command lease again", why);
  }
}
