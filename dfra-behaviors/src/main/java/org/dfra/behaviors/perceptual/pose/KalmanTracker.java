package org.dfra.behaviors.perceptual.pose;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;
import org.dfra.behaviors.perceptual.pose.FilterInput.MotionIncrement;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Transform;
import org.jspecify.annotations.Nullable;

/**
 * An extended Kalman filter of pose, gyro bias, wheel scale and the slow error of each receiver;
 * see {@link Belief}. Late fixes are used at their own time; see {@link DelayedFixFilter}.
 *
 * <p>A filter that is linearized about its belief needs an approximate yaw. So it starts only when
 * the path has determined the yaw, and until then gives the estimates of {@link FixWindowTracker}.
 * It returns to these on evident divergence.
 *
 * <pre>
 *                  yaw certain enough
 *   ALIGNING ------------------------------&gt; TRACKING --. all fixes rejected for the timeout:
 *      ^                                        |  ^    | position covariance inflated, once
 *      `----------------------------------------'  `----'
 *        all fixes rejected again, courses rejected
 *        for the timeout, yaw lost, or invalid numbers
 * </pre>
 *
 * <p>Confined to one thread.
 */
final class KalmanTracker implements PoseTracker {

  /** Minimum number of consecutive rejected fixes before the covariance is inflated. */
  private static final int ENOUGH = 5;

  /**
   * A new inflation within this multiple of the rejection timeout after the last counts as a
   * repeated one.
   */
  private static final int SUSPICION_LASTS = 4;

  private static final double DOUBTED_YAW = 0.2; // radians
  private static final double LOST_YAW = 1; // radians

  private static final int MOST_WAITING = 16;

  /**
   * Prior knowledge of the initial yaw.
   *
   * @param yaw radians, 0 is east, counter-clockwise is +
   * @param sigma its standard deviation, radians, above 0
   */
  public record InitialYaw(double yaw, double sigma) {

    public InitialYaw {
      if (!Double.isFinite(yaw) || !(sigma > 0 && sigma < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException(
            "a yaw of " + yaw + " ± " + sigma + " rad is not finite; give finite numbers");
      }
    }
  }

  private final TrackerSettings settings;
  private final FixPreprocessor intake;
  private final PoseEstimateFactory poses;
  private final DeadReckoning reckoning;
  private final DelayedFixFilter replay;
  private final Belief ahead;
  private final List<LocalFix> waiting = new ArrayList<>();
  private final RejectionCounter positions;
  private final RejectionCounter courses;
  private @Nullable InitialYaw known;
  private boolean isTracking;
  private long used;
  private boolean hasDoubted;
  private long doubted;

  /**
   * @param frame name of the frame of its estimates
   * @param datum origin of that frame; null to use the position of the first fix
   * @param known prior of the initial yaw; null for none
   */
  public KalmanTracker(
      TrackerSettings settings,
      String frame,
      @Nullable GeoPosition datum,
      @Nullable InitialYaw known) {
    this.settings = settings;
    this.intake = new FixPreprocessor(settings.gps(), datum);
    this.poses = new PoseEstimateFactory(frame, intake);
    this.reckoning = new DeadReckoning(settings);
    this.replay = new DelayedFixFilter(settings);
    this.ahead = new Belief(settings);
    this.positions = new RejectionCounter(ENOUGH, settings.rejectionTimeout().toNanos());
    this.courses = new RejectionCounter(ENOUGH, settings.rejectionTimeout().toNanos());
    this.known = known;
  }

  @Override
  public void addMeasurement(AngularRate rate) {
    reckoning.take(rate);
  }

  @Override
  public void addMeasurement(Odometry odometry) {
    follow(reckoning.take(odometry));
  }

  @Override
  public void addMeasurement(GpsFix fix, String source, Transform antenna, Instant received) {
    LocalFix local = intake.process(fix, source, antenna, received);
    if (local == null) {
      return;
    }
    follow(reckoning.advanceTo(local.time()));
    if (local.isNewSource()) {
      reckoning.window().clear();
      if (isTracking) {
        replay.head().resetReceiverBias(local.slot());
        replay.rebase();
      }
    }
    reckoning.add(local);
    if (!isTracking) {
      used = local.time();
      align();
    } else if (local.time() > replay.head().time()) {
      if (waiting.size() < MOST_WAITING) {
        waiting.add(local);
      }
    } else {
      correct(local);
    }
  }

  private void follow(@Nullable MotionIncrement step) {
    if (step == null) {
      return;
    }
    if (!isTracking) {
      align();
      return;
    }
    replay.add(step);
    if (step.isClockJump()) {
      waiting.clear();
      positions.clear();
      courses.clear();
      used = step.time();
    }
    for (LocalFix fix : List.copyOf(waiting)) {
      if (isTracking && fix.time() <= replay.head().time()) {
        waiting.remove(fix);
        correct(fix);
      }
    }
    if (isTracking && (replay.head().yawSigma() > LOST_YAW || !replay.head().isValid())) {
      realign(step.time());
    }
  }

  private void correct(LocalFix fix) {
    switch (replay.add(fix)) {
      case USED -> {
        used = Math.max(used, fix.time());
        positions.clear();
        if (replay.head().canUseCourse(fix)) {
          courses.clear();
        }
      }
      case REJECTED -> {
        if (positions.recordRejection(fix.time())) {
          suspectPosition(fix);
        }
      }
      case COURSE_REJECTED -> {
        used = Math.max(used, fix.time());
        positions.clear();
        if (courses.recordRejection(fix.time())) {
          realign(courses.since());
        }
      }
      case TOO_LATE -> {}
    }
  }

  /** All fixes were rejected for the timeout: the position is wrong, or more states are. */
  private void suspectPosition(LocalFix fix) {
    long lasts = SUSPICION_LASTS * settings.rejectionTimeout().toNanos();
    if (hasDoubted && Math.abs(fix.time() - doubted) < lasts) {
      realign(positions.since());
      return;
    }
    hasDoubted = true;
    doubted = fix.time();
    Belief head = replay.head();
    double off =
        Math.hypot(fix.east() - head.get(Belief.EAST), fix.north() - head.get(Belief.NORTH));
    head.inflate(off, DOUBTED_YAW);
    replay.rebase();
    positions.clear();
  }

  /** Restarts with the inputs since a time; keeps only the estimated sensor parameters. */
  private void realign(long since) {
    isTracking = false;
    waiting.clear();
    positions.clear();
    courses.clear();
    hasDoubted = false;
    reckoning.window().clearBefore(since);
    align();
  }

  /** Starts to track if the yaw is certain enough. */
  private void align() {
    Optional<Alignment> found = reckoning.align().map(this::withKnown);
    if (found.isEmpty() || !(found.get().yawSigma() < settings.maxInitialYawSigma())) {
      return;
    }
    Belief head = replay.head();
    BeliefInitializer.initialize(head, found.get(), reckoning, settings);
    replay.rebase();
    isTracking = head.isValid();
    known = null;
  }

  /** The alignment fused with the prior of the yaw, if that has not been used. */
  private Alignment withKnown(Alignment found) {
    InitialYaw before = known;
    if (before == null) {
      return found;
    }
    // The track starts with yaw 0, so its angle to the map is the robot's initial yaw.
    return found.with(before.yaw(), 1 / (before.sigma() * before.sigma()));
  }

  @Override
  public Optional<PoseEstimate> estimate(Instant now) {
    long time = Math.max(EpochNanos.of(now), reckoning.steps().time());
    double speed = reckoning.steps().speed();
    if (!isTracking) {
      DeadReckoningTrack.Pose pose = reckoning.predict(time);
      return reckoning
          .align()
          .map(this::withKnown)
          .flatMap(
              found ->
                  poses.estimate(
                      time,
                      FixWindowTracker.toPose(found, pose, settings),
                      speed,
                      reckoning.yawRate(),
                      used));
    }
    Belief head = replay.head();
    double rate = reckoning.steps().gyroYawRate();
    ahead.set(head);
    if (time > head.time()) {
      ahead.predict(reckoning.steps().extrapolate(time));
    }
    return poses.estimate(
        time,
        new PoseEstimateFactory.UncertainPose(
            ahead.get(Belief.EAST),
            ahead.get(Belief.NORTH),
            ahead.get(Belief.YAW),
            ahead.positionSigma(),
            ahead.yawSigma()),
        speed * (1 + head.get(Belief.WHEEL_SCALE)),
        Double.isNaN(rate) ? reckoning.steps().wheelYawRate() : rate - head.get(Belief.GYRO_BIAS),
        used);
  }

  /** The newest belief, for tests; empty while ALIGNING. */
  Optional<Belief> belief() {
    return isTracking ? Optional.of(replay.head()) : Optional.empty();
  }

  /** Counts consecutive rejections. */
  private static final class RejectionCounter {

    private final int enough;
    private final long span;
    private int count;
    private long since;

    /**
     * @param enough limit of consecutive rejections
     * @param span minimum duration of the series, nanoseconds
     */
    RejectionCounter(int enough, long span) {
      this.enough = enough;
      this.span = span;
    }

    /** Counts one more; returns whether count and duration exceed the limits. */
    boolean recordRejection(long time) {
      since = count == 0 ? time : Math.min(since, time);
      count++;
      return count >= enough && time - since >= span;
    }

    /** Resets the count. */
    void clear() {
      count = 0;
    }

    /** Time of the first in the series, nanoseconds by the robot's clock. */
    long since() {
      return since;
    }
  }
}
