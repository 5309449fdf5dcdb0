package org.dfra.experiments.recruit.simulation;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntConsumer;
import java.util.random.RandomGenerator;
import org.dfra.agent.HelpCall;
import org.dfra.experiments.recruit.simulation.ExperimentField.FieldPoint;
import org.dfra.experiments.recruit.simulation.ExperimentField.RasterRoute;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.agent.RobotPort;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * A robot in the field. It is stationary, follows a raster route, or drives in a straight line; on
 * a trip it is slightly slower than its ETA, since wheels slip. After helping, a scanner drives
 * back to the point where it left its route and continues there; others stay at their position.
 *
 * <p>Thread-safe. It reports an arrival without holding a lock.
 */
final class ExperimentRobot implements RobotPort {

  /** Metres per second, of a ground vehicle. */
  static final double SPEED = 1;

  private static final double SLIP = 0.03; // σ of the relative excess of a trip's duration

  private final Scheduler time;
  private final Set<String> percepts;
  private final double speed;
  private final RandomGenerator random;
  private final @Nullable RasterRoute route;

  // metres along the route, where it was last on it
  @GuardedBy("this")
  private double way;

  @GuardedBy("this")
  private boolean isScanning;

  // start of the drive, or its stationary position
  @GuardedBy("this")
  private FieldPoint from;

  @GuardedBy("this")
  private FieldPoint to;

  // seconds: start of the drive, or of the route
  @GuardedBy("this")
  private double since;

  // duration of the drive, seconds
  @GuardedBy("this")
  private double lasts;

  @GuardedBy("this")
  private Scheduler.@Nullable ScheduledTask journey;

  // of the task of the drive, nanoseconds
  @GuardedBy("this")
  private long leaseEnd;

  // so far; number of the current one
  @GuardedBy("this")
  private int drives;

  @GuardedBy("this")
  private boolean isAlive = true;

  @GuardedBy("this")
  private double travelled;

  @GuardedBy("this")
  private double lost;

  @GuardedBy("this")
  private double leftRouteAt;

  /**
   * @param route that it scans along; null for a stationary one
   * @param begin its position, or metres along its route, as {@code east}
   */
  ExperimentRobot(
      Scheduler time,
      Set<String> percepts,
      double speed,
      RandomGenerator random,
      @Nullable RasterRoute route,
      FieldPoint begin) {
    this.time = time;
    this.percepts = percepts;
    this.speed = speed;
    this.random = random;
    this.route = route;
    this.isScanning = route != null;
    this.way = route == null ? 0 : begin.east();
    this.from = route == null ? begin : route.at(begin.east());
    this.to = from;
    this.since = seconds();
  }

  private double seconds() {
    return time.nanos() / 1e9;
  }

  /** Its position. */
  synchronized FieldPoint position() {
    RasterRoute along = route;
    if (isScanning && along != null) {
      return along.at(way + (seconds() - since) * speed);
    }
    double share = lasts == 0 ? 1 : Math.min(1, (seconds() - since) / lasts);
    return from.towards(to, share);
  }

  /** Distance driven for others and back, metres. */
  synchronized double travelled() {
    return travelled;
  }

  /** Time away from its route, seconds. */
  synchronized double rasterTimeLost() {
    return lost + (route != null && !isScanning ? seconds() - leftRouteAt : 0);
  }

  /** Stops it permanently, without a notification. */
  synchronized void die() {
    stand();
    isAlive = false;
  }

  /** Travel time to a place, seconds. */
  synchronized double seconds(FieldPoint place) {
    return position().distance(place) / speed;
  }

  @Override
  public boolean canObserve(String percept) {
    return percepts.contains(percept);
  }

  @Override
  public synchronized boolean isAvailable() {
    return isAlive;
  }

  @Override
  public boolean hasOwnWork() {
    return route != null;
  }

  @Override
  public boolean isInField(GeoPosition place) {
    return ExperimentField.contains(ExperimentField.toField(place));
  }

  @Override
  public Optional<Duration> eta(GeoPosition place) {
    return Optional.of(Duration.ofNanos((long) (seconds(ExperimentField.toField(place)) * 1e9)));
  }

  @Override
  public double battery() {
    return 1;
  }

  @Override
  public synchronized void travelTo(HelpCall call, long leaseEnd, TravelListener listener) {
    leaveRoute();
    drive(ExperimentField.toField(call.position()), number -> listener.arrived());
    extendLease(leaseEnd);
    awaitLeaseEnd(drives, listener);
  }

  @GuardedBy("this")
  private void awaitLeaseEnd(int number, TravelListener reported) {
    Scheduler.ScheduledTask unused =
        time.after(leaseEnd - time.nanos(), () -> overdue(number, reported));
  }

  @Override
  public synchronized void extendLease(long end) {
    leaseEnd = end;
  }

  /** The lease of the task that it still drives for has ended. */
  private void overdue(int number, TravelListener reported) {
    synchronized (this) {
      if (!isUnderWay(number) || journey == null) {
        return;
      }
      if (time.nanos() < leaseEnd) { // it was extended
        awaitLeaseEnd(number, reported);
        return;
      }
      stand();
    }
    reported.failed("its lease of the task has ended");
  }

  @GuardedBy("this")
  private void leaveRoute() {
    if (isScanning) {
      double now = seconds();
      way += (now - since) * speed;
      since = now;
      leftRouteAt = now;
    }
  }

  @GuardedBy("this")
  private void drive(FieldPoint target, IntConsumer there) {
    FieldPoint here = position();
    stand();
    isScanning = false;
    from = here;
    to = target;
    since = seconds();
    lasts = here.distance(target) / speed * (1 + SLIP * Math.abs(random.nextGaussian()));
    travelled += here.distance(target);
    int number = ++drives;
    journey =
        time.after(
            Math.round(lasts * 1e9),
            () -> {
              if (isUnderWay(number)) {
                there.accept(number);
              }
            });
  }

  /** Whether that drive has neither ended nor been cancelled before its end is reported. */
  private synchronized boolean isUnderWay(int number) {
    return isAlive && number == drives;
  }

  @GuardedBy("this")
  private void stand() {
    if (journey != null) {
      journey.cancel();
      drives++;
    }
    FieldPoint here = position();
    double left = isScanning || lasts == 0 ? 0 : here.distance(to);
    travelled -= left; // counted at its start
    if (!isScanning) {
      from = here;
      to = here;
      lasts = 0;
    }
  }

  @Override
  public synchronized void observe(HelpCall call) {
    stand();
  }

  @Override
  public synchronized void resumeOwnWork() {
    RasterRoute along = route;
    if (along == null) {
      stand();
    } else if (!isScanning) {
      drive(along.at(way), this::scanAgain);
    }
  }

  private synchronized void scanAgain(int number) {
    if (number != drives) {
      return; // it was interrupted in between
    }
    lost += seconds() - leftRouteAt;
    isScanning = true;
    since = seconds();
  }
}
