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
 *   <li>{@code method}: {@code kalman}, {@code history} or {@code raw}; default {@code kalman}
 *   <li>{@code datum}: latitude and longitude in degrees, the origin of east and north; default the
 *       first fix
 *   <li>{@code gps_white}, {@code gps_bias}: standard deviations of a fix, metres, 0.01 to 50 and 0
 *       to 50; {@code gps_bias_time}: correlation time of the second, seconds, 1 to 100 000
 *   <li>{@code wheel_scale}, {@code wheel_turn_scale}: standard deviations of the wheels' scale
 *       errors of distance and yaw, 0.001 to 1; {@code wheel_slip}: of the distance after a metre,
 *       metres, 0.001 to 1; {@code wheel_turn_slip}: of the yaw after a radian, radians, 0.001 to 2
 *   <li>{@code gyro_noise}: density of the gyro's white noise, rad/s per root hertz, 0.000001 to 1;
 *       {@code gyro_bias}: standard deviation of its bias, rad/s, 0.000001 to 1; {@code
 *       gyro_drift}: of the bias' change after a second, rad/s, 0.0000001 to 0.1
 *   <li>{@code gate}: squared Mahalanobis distance beyond which a fix is rejected, 1 to 1000;
 *       default 13.8
 *   <li>{@code initial_yaw}: yaw at the start, radians, 0 is east, counter-clockwise is +, −6.3 to
 *       6.3, if known; {@code initial_yaw_sigma}: its standard deviation, radians, 0.01 to 1;
 *       default 0.1; only the method {@code kalman} uses them
 *   <li>{@code window}: length of the fix window of {@code history}, seconds, 2 to 120; default 20
 *   <li>{@code odometry}, {@code gyro}: names of the modules to use; default the first suitable one
 *   <li>{@code longest_age}: as for every perceptual schema; default 0.5
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
        "where the robot is, by odometry, gyro and satellites",
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
            settings.number("gps_white", gps.whiteNoiseSigma(), 0.01, 50),
            settings.number("gps_bias", gps.biasSigma(), 0, 50),
            settings.number("gps_bias_time", gps.biasCorrelationTime(), 1, 100_000),
            gps.velocitySigma(),
            gps.minCourseSpeed(),
            gps.minLatency(),
            gps.referenceDilution());
    Duration window =
        settings.seconds("window", usual.fixWindow(), Duration.ofSeconds(2), Duration.ofMinutes(2));
    return new TrackerSettings(
        reported,
        wheels(settings, usual.wheels()),
        gyro(settings, usual.gyro()),
        settings.number("gate", usual.positionGate(), 1, 1000),
        usual.courseGate(),
        window,
        usual.maxFixDelay(),
        usual.rejectionTimeout(),
        usual.maxInitialYawSigma());
  }

  private static WheelErrors wheels(Parameters settings, WheelErrors usual) {
    return new WheelErrors(
        settings.number("wheel_scale", usual.scaleSigma(), 0.001, 1),
        settings.number("wheel_turn_scale", usual.yawScaleSigma(), 0.001, 1),
        settings.number("wheel_slip", usual.longitudinalSlip(), 0.001, 1),
        usual.lateralSlip(),
        settings.number("wheel_turn_slip", usual.yawSlip(), 0.001, 2),
        usual.yawRandomWalk(),
        usual.maxSpeed(),
        usual.maxYawRate());
  }

  private static GyroErrors gyro(Parameters settings, GyroErrors usual) {
    return new GyroErrors(
        settings.number("gyro_noise", usual.noiseDensity(), 1e-6, 1),
        settings.number("gyro_bias", usual.biasSigma(), 1e-6, 1),
        settings.number("gyro_drift", usual.biasRandomWalk(), 1e-7, 0.1),
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
}
