package org.dfra.examples.mission;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.Reading;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.ModuleReadings.Advice;
import org.dfra.examples.mission.ModuleReadings.ClearanceReading;
import org.dfra.examples.mission.ModuleReadings.Fix;
import org.dfra.examples.mission.ModuleReadings.TeammateDistance;
import org.dfra.flow.motor.DriveAdvice;
import org.dfra.flow.motor.FuzzyDrive;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.flow.perceptual.RangeFilter;
import org.dfra.flow.perceptual.TeamPositions;
import org.dfra.flow.perceptual.TeamTracker;
import org.dfra.flow.perceptual.Teammate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.module.Module;
import org.dfra.time.ClockOffset;
import org.jspecify.annotations.Nullable;

/**
 * The record of one robot's search: the readings of its modules, compared with the ground truth.
 * Thread-safe, since each module reports from its own thread.
 */
public final class RobotLog {

  /** The estimator that robots steer by; others only estimate. */
  public static final String STEERING = "position";

  /** Types of the modules that are subscribed to. */
  public static final List<Class<? extends Module>> RECORDED_KINDS =
      List.of(
          PositionEstimator.class,
          LocationSensor.class,
          FuzzyDrive.class,
          RangeFilter.class,
          TeamTracker.class);

  private final String robot;
  private final LocalFrame frame;

  @GuardedBy("this")
  private final List<Sample> samples = new ArrayList<>();

  @GuardedBy("this")
  private final List<Fix> fixes = new ArrayList<>();

  @GuardedBy("this")
  private final List<Advice> advice = new ArrayList<>();

  @GuardedBy("this")
  private final List<ClearanceReading> clearances = new ArrayList<>();

  @GuardedBy("this")
  private final List<TeammateDistance> teammates = new ArrayList<>();

  // by robot; indices into teammates
  @GuardedBy("this")
  private final Map<String, Instant> lastSeen = new TreeMap<>();

  // by module
  @GuardedBy("this")
  private final Map<String, LocalPosition> estimated = new TreeMap<>();

  // by module
  @GuardedBy("this")
  private final Map<String, ErrorSum> errors = new TreeMap<>();

  @GuardedBy("this")
  private double estimatedYaw = Double.NaN;

  @GuardedBy("this")
  private @Nullable LocalPosition fixed;

  @GuardedBy("this")
  private @Nullable Instant begin;

  /** The error sum of one estimator. */
  private static final class ErrorSum {
    private double squares;
    private long count;

    void add(double metres) {
      squares += metres * metres;
      count++;
    }

    double rms() {
      return Math.sqrt(squares / count);
    }
  }

  /**
   * @param robot its name
   * @param frame the region's
   */
  public RobotLog(String robot, LocalFrame frame) {
    this.robot = robot;
    this.frame = frame;
  }

  /** The query for modules of one type to subscribe to. */
  public <M extends Module> ModuleQuery<M> query(Class<M> kind) {
    return ModuleQuery.of(kind).robot(robot);
  }

  /** The search starts now. Earlier poses still count; other earlier readings do not. */
  public synchronized void begin(Instant now) {
    begin = now;
  }

  /**
   * Records a module's readings.
   *
   * @param module its name
   */
  public ModuleListener listener(String module) {
    return delivery -> {
      if (delivery.event() instanceof ModuleEvent.NewReading fresh) {
        record(module, fresh.reading());
      }
    };
  }

  private synchronized void record(String module, Reading reading) {
    if (reading instanceof PoseEstimate pose) {
      estimated.put(module, frame.toLocal(pose.position()));
      if (module.equals(STEERING)) {
        estimatedYaw = pose.yaw();
      }
    } else if (reading instanceof GpsFix fix) {
      @Nullable GeoPosition position = fix.position();
      if (position != null) {
        fixed = frame.toLocal(position);
      }
    }
    double time = time(reading);
    if (time >= 0) {
      note(time, module, reading);
    }
  }

  @GuardedBy("this")
  private void note(double time, String module, Reading reading) {
    if (reading instanceof GpsFix fix && fix.position() != null) {
      LocalPosition at = frame.toLocal(fix.position());
      fixes.add(new Fix(time, module, at.east(), at.north()));
    } else if (reading instanceof DriveAdvice reported) {
      advice.add(
          new Advice(
              time,
              reported.velocity().speed(),
              reported.velocity().yawRate(),
              reported.reason(),
              reported.strength()));
    } else if (reading instanceof Clearance clearance) {
      clearances.add(
          new ClearanceReading(time, clearance.left(), clearance.centre(), clearance.right()));
    } else if (reading instanceof TeamPositions reported) {
      reported.teammates().forEach(this::note);
    }
  }

  @GuardedBy("this")
  private void note(Teammate teammate) {
    Teammate.@Nullable RelativePosition near = teammate.relativePosition();
    @Nullable ClockOffset clock = teammate.clockOffset();
    if (near != null && clock != null && !near.time().equals(lastSeen.get(teammate.robot()))) {
      lastSeen.put(teammate.robot(), near.time());
      teammates.add(
          new TeammateDistance(time(near.time()), teammate.robot(), near.distance(), clock));
    }
  }

  @GuardedBy("this")
  private double time(Instant moment) {
    return begin == null ? -1 : Duration.between(begin, moment).toNanos() / 1e9;
  }

  /** Seconds since the search began; negative before. */
  @GuardedBy("this")
  private double time(Reading reading) {
    return time(reading.measured());
  }

  /**
   * Records the robot's true and estimated poses.
   *
   * @param truth ground truth: only time, position, heading and clearance are used
   * @param status progress of its search
   */
  public synchronized MissionProgressListener.RobotProgress sample(
      GroundTruth truth, BehaviorStatus status) {
    estimated.forEach(
        (module, position) ->
            errors
                .computeIfAbsent(module, unused -> new ErrorSum())
                .add(Math.hypot(position.east() - truth.east(), position.north() - truth.north())));
    @Nullable LocalPosition believed = estimated.get(STEERING);
    @Nullable LocalPosition fix = fixed;
    Sample sample =
        new Sample(
            truth.time(),
            truth.east(),
            truth.north(),
            truth.yaw(),
            truth.speed(),
            believed == null ? Double.NaN : believed.east(),
            believed == null ? Double.NaN : believed.north(),
            estimatedYaw,
            fix == null ? Double.NaN : fix.east(),
            fix == null ? Double.NaN : fix.north(),
            status.completion(),
            truth.clearance());
    samples.add(sample);
    return new MissionProgressListener.RobotProgress(robot, sample, status);
  }

  /**
   * The robot's ground truth, in the region's frame.
   *
   * @param time seconds since the search began
   * @param east metres
   * @param north metres
   * @param yaw radians, 0 is east, counter-clockwise is +
   * @param speed over ground, metres per second
   * @param clearance from its body to the nearest obstacle or robot, metres
   */
  public record GroundTruth(
      double time, double east, double north, double yaw, double speed, double clearance) {}

  /** The complete record. */
  public synchronized RobotMissionResult result(BehaviorStatus last) {
    Map<String, Double> rms = new TreeMap<>();
    errors.forEach((module, sum) -> rms.put(module, sum.rms()));
    return new RobotMissionResult(
        robot,
        last.phase() == BehaviorStatus.Phase.SUCCEEDED,
        last.activity(),
        samples,
        rms,
        new ModuleReadings(fixes, advice, clearances, teammates));
  }

  /**
   * One sample of one robot's search, in the region's frame: east, north, metres.
   *
   * @param time seconds since the search began
   * @param east true position
   * @param north true position
   * @param yaw true heading, radians
   * @param speed true speed over ground, metres per second
   * @param estimatedEast estimated position; NaN while unknown
   * @param estimatedNorth likewise
   * @param estimatedYaw likewise, radians
   * @param fixEast its last position by a receiver; NaN before the first
   * @param fixNorth likewise
   * @param done share of its waypoints that are done, 0 to 1
   * @param clearance from its body to the nearest obstacle or robot, metres; 0 is contact
   */
  public record Sample(
      double time,
      double east,
      double north,
      double yaw,
      double speed,
      double estimatedEast,
      double estimatedNorth,
      double estimatedYaw,
      double fixEast,
      double fixNorth,
      double done,
      double clearance) {

    /** Whether it has a position estimate. */
    public boolean isEstimated() {
      return !Double.isNaN(estimatedEast);
    }
  }
}
