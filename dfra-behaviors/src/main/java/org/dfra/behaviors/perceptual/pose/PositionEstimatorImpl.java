package org.dfra.behaviors.perceptual.pose;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dfra.behaviors.perceptual.pose.KalmanTracker.InitialYaw;
import org.dfra.behaviors.perceptual.pose.TrackerSettings.GpsErrors;
import org.dfra.behaviors.perceptual.pose.TrackerSettings.GyroErrors;
import org.dfra.behaviors.perceptual.pose.TrackerSettings.WheelErrors;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.PerceptualSchemaImpl;
import org.dfra.directory.ModuleListing;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.AngularRateSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationSensor;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Transform;
import org.dfra.persona.PerceptualSchemaAttributes;
import org.dfra.persona.PoseAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Estimates its robot's pose from the odometry, the gyro and every location sensor of the robot;
 * see {@link PoseTracker}. It publishes an estimate with each odometry reading.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code method}: {@code kalman}, {@code fix_window} or {@code raw}; default {@code kalman}
 *   <li>{@code datum}: latitude and longitude in degrees, the origin of east and north; default the
 *       first fix
 *   <li>{@code gps_white_noise_sigma}, {@code gps_bias_sigma}: standard deviations of a fix,
 *       metres, 0.01 to 50 and 0 to 50; {@code gps_bias_correlation_time}: correlation time of the
 *       second, seconds, 1 to 100 000
 *   <li>{@code wheel_scale_sigma}, {@code wheel_yaw_scale_sigma}: standard deviations of the
 *       wheels' scale errors of distance and yaw, 0.001 to 1; {@code wheel_slip}: of the distance
 *       after a metre, metres, 0.001 to 1; {@code wheel_yaw_slip}: of the yaw after a radian,
 *       radians, 0.001 to 2
 *   <li>{@code gyro_noise_density}: density of the gyro's white noise, rad/s per root hertz,
 *       0.000001 to 1; {@code gyro_bias_sigma}: standard deviation of its bias, rad/s, 0.000001 to
 *       1; {@code gyro_bias_random_walk}: of the bias' change after a second, rad/s, 0.0000001 to
 *       0.1
 *   <li>{@code position_gate}: squared Mahalanobis distance beyond which a fix is rejected, 1 to
 *       1000; default 13.8
 *   <li>{@code initial_yaw}: yaw at the start, radians, 0 is east, counter-clockwise is +, −6.3 to
 *       6.3, if known; {@code initial_yaw_sigma}: its standard deviation, radians, 0.01 to 1;
 *       default 0.1; only the method {@code kalman} uses them
 *   <li>{@code fix_window}: length of the fix window of {@code fix_window}, seconds, 2 to 120;
 *       default 20
 *   <li>{@code odometry}, {@code gyro}: names of the modules to use; default the first suitable one
 *   <li>{@code max_age}: as for every perceptual schema; default 0.5
 * </ul>
 */
public final class PositionEstimatorImpl extends PerceptualSchemaImpl<PoseEstimate>
    implements PositionEstimator {

  private final TrackerKind kind;
  private final PoseTracker tracker; // guarded by itself

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public PositionEstimatorImpl(ModuleContext context) {
    super(
        context,
        "the robot's pose, from odometry, gyro and satellites",
        "DFRA",
        "1",
        PoseEstimate.class,
        "PoseEstimate",
        0.5);
    this.kind = kind(settings());
    this.tracker =
        kind.create(
            trackerSettings(settings()),
            context.robot() + "/map",
            datum(settings()),
            yaw(settings()));
    declareInput(
        OdometrySensor.class, "odometry", Odometry.class, (source, reading) -> take(reading));
    declareInput(
        AngularRateSensor.class, "gyro", AngularRate.class, (source, reading) -> take(reading));
    declareInputFromAll(LocationSensor.class, GpsFix.class, this::take);
  }

  private static TrackerKind kind(Parameters settings) {
    String text = settings.find("method").orElse("kalman").strip();
    return Arrays.stream(TrackerKind.values())
        .filter(each -> each.name().toLowerCase(Locale.ROOT).equals(text))
        .findFirst()
        .orElseThrow(
            () ->
                settings.fault(
                    "method",
                    Arrays.stream(TrackerKind.values())
                        .map(each -> each.name().toLowerCase(Locale.ROOT))
                        .collect(Collectors.joining(", ", "one of ", "")),
                    null));
  }

  private static TrackerSettings trackerSettings(Parameters settings) {
    TrackerSettings usual = TrackerSettings.DEFAULT;
    GpsErrors gps = usual.gps();
    GpsErrors reported =
        new GpsErrors(
            settings.number("gps_white_noise_sigma", gps.whiteNoiseSigma(), 0.01, 50),
            settings.number("gps_bias_sigma", gps.biasSigma(), 0, 50),
            settings.number("gps_bias_correlation_time", gps.biasCorrelationTime(), 1, 100_000),
            gps.velocitySigma(),
            gps.minCourseSpeed(),
            gps.minLatency(),
            gps.referenceDilution());
    Duration window =
        settings.seconds(
            "fix_window", usual.fixWindow(), Duration.ofSeconds(2), Duration.ofMinutes(2));
    return new TrackerSettings(
        reported,
        wheels(settings, usual.wheels()),
        gyro(settings, usual.gyro()),
        settings.number("position_gate", usual.positionGate(), 1, 1000),
        usual.courseGate(),
        window,
        usual.maxFixDelay(),
        usual.rejectionTimeout(),
        usual.maxInitialYawSigma());
  }

  private static WheelErrors wheels(Parameters settings, WheelErrors usual) {
    return new WheelErrors(
        settings.number("wheel_scale_sigma", usual.scaleSigma(), 0.001, 1),
        settings.number("wheel_yaw_scale_sigma", usual.yawScaleSigma(), 0.001, 1),
        settings.number("wheel_slip", usual.longitudinalSlip(), 0.001, 1),
        usual.lateralSlip(),
        settings.number("wheel_yaw_slip", usual.yawSlip(), 0.001, 2),
        usual.yawRandomWalk(),
        usual.maxSpeed(),
        usual.maxYawRate());
  }

  private static GyroErrors gyro(Parameters settings, GyroErrors usual) {
    return new GyroErrors(
        settings.number("gyro_noise_density", usual.noiseDensity(), 1e-6, 1),
        settings.number("gyro_bias_sigma", usual.biasSigma(), 1e-6, 1),
        settings.number("gyro_bias_random_walk", usual.biasRandomWalk(), 1e-7, 0.1),
        usual.scaleNoise());
  }

  private static @Nullable InitialYaw yaw(Parameters settings) {
    double sigma = settings.number("initial_yaw_sigma", 0.1, 0.01, 1);
    return settings.find("initial_yaw").isEmpty()
        ? null
        : new InitialYaw(settings.number("initial_yaw", 0, -6.3, 6.3), sigma);
  }

  private static @Nullable GeoPosition datum(Parameters settings) {
    if (settings.find("datum").isEmpty()) {
      return null;
    }
    String[] parts = settings.text("datum").strip().split("[\\s,]+");
    try {
      if (parts.length == 2) {
        return new GeoPosition(Double.parseDouble(parts[0]), Double.parseDouble(parts[1]), 0);
      }
    } catch (IllegalArgumentException e) {
      throw settings.fault("datum", "latitude and longitude in degrees", e);
    }
    throw settings.fault("datum", "latitude and longitude in degrees", null);
  }

  private void take(Odometry reading) {
    synchronized (tracker) {
      tracker.addMeasurement(reading);
      tracker.estimate(clock().instant()).ifPresent(this::publishPercept);
    }
  }

  private void take(AngularRate reading) {
    synchronized (tracker) {
      tracker.addMeasurement(reading);
    }
  }

  private void take(ModuleListing<?> source, GpsFix fix) {
    Instant received = clock().instant();
    Transform antenna =
        source
            .attributes(PoseAttributes.class)
            .map(at -> Transform.of(at.x(), at.y(), at.z(), at.roll(), at.pitch(), at.yaw()))
            .orElse(Transform.IDENTITY);
    synchronized (tracker) {
      tracker.addMeasurement(fix, source.path(), antenna, received);
    }
  }

  @Override
  protected PerceptualSchemaAttributes schemaAttributes() {
    return new PerceptualSchemaAttributes(
        "PoseEstimate", "covariance", kind.name().toLowerCase(Locale.ROOT), null, null);
  }

  @Override
  public PoseEstimate estimate() {
    return percept();
  }

  /** The methods of pose tracking. */
  enum TrackerKind {
    /** An extended Kalman filter: {@link KalmanTracker}. */
    KALMAN,
    /** The last fixes against dead reckoning: {@link FixWindowTracker}. */
    FIX_WINDOW,
    /** The last fix as it is: {@link RawGpsTracker}. */
    RAW;

    /**
     * A new tracker of this kind.
     *
     * @param frame name of the frame of its estimates, e.g. {@code atrv1/map}
     * @param datum origin of that frame; null to use the position of the first fix
     */
    public PoseTracker create(TrackerSettings settings, String frame, @Nullable GeoPosition datum) {
      return create(settings, frame, datum, null);
    }

    /**
     * The same.
     *
     * @param known prior of the initial yaw, which only {@link #KALMAN} uses; null for none
     */
    public PoseTracker create(
        TrackerSettings settings,
        String frame,
        @Nullable GeoPosition datum,
        KalmanTracker.@Nullable InitialYaw known) {
      return switch (this) {
        case KALMAN -> new KalmanTracker(settings, frame, datum, known);
        case FIX_WINDOW -> new FixWindowTracker(settings, frame, datum);
        case RAW -> new RawGpsTracker(settings, frame, datum);
      };
    }
  }
}
