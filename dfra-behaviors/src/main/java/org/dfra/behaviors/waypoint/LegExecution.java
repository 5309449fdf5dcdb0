package org.dfra.behaviors.waypoint;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.motor.FuzzyDrive;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingError;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.flow.perceptual.RangeFilter;
import org.dfra.geometry.Leg;
import org.dfra.lease.LeaseRefusedException;
import org.jspecify.annotations.Nullable;

/**
 * Executes one leg. Each cycle it reads the percepts, evaluates the controller, and commands the
 * wheels. It reduces the clearance for late percepts and cycles, see {@link ClearanceMargin}.
 */
final class LegExecution implements GoalExecution {

  /**
   * Dependencies of a leg.
   *
   * @param headingError supplies the current module; likewise range filter and controller
   * @param nanos the robot's time
   * @param clock of the percepts
   * @param maxPeerSpeed maximum speed of other robots, metres per second
   * @param maxRecoveries recoveries on one leg after which it counts as unreachable
   * @param passingTolerance metres beside its end at which a passed leg counts as reached
   */
  record Dependencies(
      Supplier<HeadingError> headingError,
      Supplier<RangeFilter> rangeFilter,
      Supplier<FuzzyDrive> fuzzyDrive,
      LeasedDrive wheels,
      LongSupplier nanos,
      InstantSource clock,
      double maxPeerSpeed,
      int maxRecoveries,
      double passingTolerance) {}

  /** The modules in use until it is suspended. */
  private record ResolvedModules(
      HeadingError headingError, RangeFilter rangeFilter, FuzzyDrive fuzzyDrive) {}

  private static final double STUCK_TIMEOUT = 6; // seconds
  private static final double NO_PROGRESS_TIMEOUT = 40; // seconds

  /**
   * With a larger standard deviation of its yaw a robot drives straight, which makes the yaw
   * observable, radians.
   */
  private static final double MAX_YAW_SIGMA = 0.6;

  private final Dependencies means;
  private final Leg leg;
  private final double tolerance;
  private final long began; // nanoseconds of the robot's time
  private volatile @Nullable Duration limit; // since its start
  private final StuckDetector watch = new StuckDetector(STUCK_TIMEOUT, NO_PROGRESS_TIMEOUT);
  private final ClearanceMargin margin;
  private @Nullable ResolvedModules resolvedModules;
  private @Nullable RecoveryManeuver recovery;
  private int recoveries;
  private double whole = Double.NaN; // initial distance, metres
  private double share; // fraction of the distance driven, 0 to 1

  /**
   * @param limit timeout of the leg from now on; null for no limit
   */
  LegExecution(Dependencies means, Leg leg, double tolerance, @Nullable Duration limit) {
    this.means = means;
    this.leg = leg;
    this.tolerance = tolerance;
    this.began = means.nanos().getAsLong();
    this.margin = new ClearanceMargin(means.maxPeerSpeed());
    this.limit = limit;
  }

  @Override
  public GoalProgress step() throws RemoteException, LeaseRefusedException {
    @Nullable Duration longest = limit;
    if (longest != null && elapsed().compareTo(longest) >= 0) {
      return GoalProgress.failed(
          String.format(
              Locale.ROOT, "its time limit of %.1f s has passed", longest.toMillis() / 1000.0),
          share);
    }
    ResolvedModules by = resolvedModules();
    HeadingPercept heading = by.headingError().towards(leg);
    if (Double.isNaN(whole)) {
      whole = Math.max(tolerance, heading.distance());
    }
    if (isThere(heading)) {
      return GoalProgress.reached(
          String.format(
              Locale.ROOT, "it has reached the waypoint, %.2f m from it", heading.distance()));
    }
    Clearance measured = by.rangeFilter().clearance();
    long now = means.nanos().getAsLong();
    Clearance clearance = margin.reduced(measured, means.clock().instant(), now);
    if (recovery != null && recovery.isOver(now)) {
      recovery = null;
      watch.reset();
    }
    if (recovery == null && watch.isStuck(now, heading)) {
      if (recoveries >= means.maxRecoveries()) {
        return GoalProgress.failed(
            String.format(
                Locale.ROOT,
                "it cannot get nearer than %.1f m; an obstacle blocks the path",
                heading.distance()),
            done(heading));
      }
      recovery = new RecoveryManeuver(now, recoveries++);
    }
    Velocity wanted = velocity(by.fuzzyDrive(), now, clearance, heading);
    margin.recordCommand(wanted, now);
    means.wheels().setVelocity(wanted);
    share = done(heading);
    return GoalProgress.inProgress(doing(heading), share);
  }

  /** Sets another time limit, from now on; any thread may call it. */
  void setTimeLimit(Duration left) {
    limit = elapsed().plus(left);
  }

  private Duration elapsed() {
    return Duration.ofNanos(means.nanos().getAsLong() - began);
  }

  /** Whether the end is reached, or was passed. */
  private boolean isThere(HeadingPercept heading) {
    return heading.distance() <= tolerance
        || (heading.remainingAlongTrack() <= 0 && heading.distance() <= means.passingTolerance());
  }

  private ResolvedModules resolvedModules() {
    ResolvedModules by = resolvedModules;
    if (by == null) {
      by =
          new ResolvedModules(
              means.headingError().get(), means.rangeFilter().get(), means.fuzzyDrive().get());
      resolvedModules = by;
    }
    return by;
  }

  private Velocity velocity(FuzzyDrive rules, long now, Clearance clearance, HeadingPercept heading)
      throws RemoteException {
    @Nullable RecoveryManeuver out = recovery;
    if (out == null) {
      HeadingPercept known =
          heading.headingSigma() > MAX_YAW_SIGMA ? heading.withoutHeadingError() : heading;
      return rules.advise(clearance, known).velocity();
    }
    @Nullable Velocity wanted = out.velocity(now, clearance);
    if (wanted != null) {
      return wanted;
    }
    return rules.advise(clearance, heading.withoutHeadingError()).velocity();
  }

  /** In whole metres, so that the status does not change in every cycle. */
  private String doing(HeadingPercept heading) {
    String how =
        recovery != null
            ? "it was stuck and recovers"
            : heading.headingSigma() > MAX_YAW_SIGMA
                ? "it drives straight on to determine its yaw"
                : "it drives";
    return how + ", " + Math.round(heading.distance()) + " m to go";
  }

  private double done(HeadingPercept heading) {
    return Math.max(0, 1 - heading.distance() / whole) * 0.99;
  }

  @Override
  public void suspend() {
    means.wheels().release();
    resolvedModules = null;
    recovery = null;
    watch.reset();
    margin.reset();
  }
}
