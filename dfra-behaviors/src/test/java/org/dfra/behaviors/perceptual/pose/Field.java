package org.dfra.behaviors.perceptual.pose;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.geometry.Transform;

/**
 * A skid-steered robot that drives lanes on a field, and the readings of its sensors. It stops for
 * ten seconds, then drives lanes of 30 m, 2 m apart, at 0.6 m/s, turning on the spot at their ends.
 * The seed determines everything.
 */
final class Field {

  static final GeoPosition DATUM = new GeoPosition(48, 11, 520);
  static final Instant START = Instant.parse("2026-05-01T09:00:00Z");

  /** Antennas ahead of and behind the middle. */
  static final List<Transform> ANTENNAS =
      List.of(Transform.translation(0.3, 0, 0.6), Transform.translation(-0.3, 0, 0.6));

  static final List<String> SOURCES = List.of("gps_front", "gps_rear");

  private static final double TICK = 0.01; // s
  private static final int ODOMETRY_TICKS = 10;
  private static final double SPEED = 0.6; // m/s
  private static final double YAW_RATE = 0.6; // rad/s
  private static final double LANE = 30; // m
  private static final double SPACING = 2; // m

  /**
   * Errors of the sensors.
   *
   * @param whiteSigma σ of a position's new error, m
   * @param bias σ of its slow error over 200 s, m
   * @param turnSlip mean part of the wheels' turn that the body lags; half of it comes and goes
   * @param hasGyro whether there is a gyro
   * @param hostAhead what the robot's clock is ahead of UTC, s
   */
  record Errors(
      double whiteSigma, double biasSigma, double turnSlip, boolean hasGyro, double hostAhead) {
    static final Errors WHITE = new Errors(0.6, 0, 0.2, true, 3.7);

    Errors withBias(double other) {
      return new Errors(whiteSigma, other, turnSlip, hasGyro, hostAhead);
    }

    Errors withoutGyro(double slip) {
      return new Errors(whiteSigma, biasSigma, slip, false, hostAhead);
    }
  }

  /** A received measurement: an Odometry, AngularRate or GpsFix, and of which antenna. */
  record Measurement(double at, Object reading, int antenna) {}

  /** The truth: metres east and north, yaw and speeds. */
  record Truth(double east, double north, double yaw, double speed, double rate) {}

  final Errors errors;
  final List<Truth> truth = new ArrayList<>();
  final List<Measurement> measurements = new ArrayList<>();
  private final SplittableRandom random;
  private final LocalFrame frame = new LocalFrame(DATUM);
  private final double[][] slow = new double[2][2];
  private double wheelX;
  private double wheelY;
  private double wheelYaw;

  Field(long seed, Errors errors, double seconds) {
    this.errors = errors;
    this.random = new SplittableRandom(seed);
    drive(seconds);
    wheels();
    if (errors.hasGyro) {
      gyro();
    }
    receivers();
    measurements.sort(Comparator.comparingDouble(Measurement::at));
  }

  double gaussian() {
    return random.nextGaussian();
  }

  /** The robot's clock, which stamps odometry and angular rates, so long after the beginning. */
  Instant host(double seconds) {
    return START.plusNanos(Math.round((seconds + errors.hostAhead) * 1e9));
  }

  static Instant utc(double seconds) {
    return START.plusNanos(Math.round(seconds * 1e9));
  }

  Truth at(double seconds) {
    return truth.get((int) Math.min(truth.size() - 1, Math.round(seconds / TICK)));
  }

  private void drive(double seconds) {
    double[][] round = {
      {LANE, 0}, {0, Math.PI / 2}, {SPACING, 0}, {0, Math.PI / 2},
      {LANE, 0}, {0, -Math.PI / 2}, {SPACING, 0}, {0, -Math.PI / 2}
    };
    double yaw = random.nextDouble(-Math.PI, Math.PI);
    double east = random.nextDouble(-20, 20);
    double north = random.nextDouble(-20, 20);
    double speed = 0;
    double rate = 0;
    double left = 10; // seconds of standing
    int segment = -1;
    for (double t = 0; t <= seconds; t += TICK) {
      truth.add(new Truth(east, north, yaw, speed, rate));
      if (left <= 0) {
        segment = (segment + 1) % round.length;
        left = Math.abs(round[segment][0] + round[segment][1]);
      }
      double wanted = segment < 0 || round[segment][0] == 0 ? 0 : SPEED;
      double turn = segment < 0 ? 0 : Math.signum(round[segment][1]) * YAW_RATE;
      speed += Math.max(-TICK, Math.min(TICK, wanted - speed)); // 1 m/s²
      rate += Math.max(-2 * TICK, Math.min(2 * TICK, turn - rate)); // 2 rad/s²
      double middle = yaw + rate * TICK / 2;
      east += speed * TICK * Math.cos(middle);
      north += speed * TICK * Math.sin(middle);
      yaw += rate * TICK;
      left -= segment < 0 ? TICK : TICK * (turn == 0 ? speed : Math.abs(rate));
    }
  }

  private void wheels() {
    double left = 1 + 0.005 * gaussian();
    double right = 1 + 0.005 * gaussian();
    double keep = Math.exp(-TICK / 2);
    double push = Math.sqrt(1 - keep * keep);
    double slip = 0;
    double turnSlip = 0;
    double track = 0.75;
    for (int i = 0; i < truth.size(); i++) {
      slip = keep * slip + push * 0.02 * gaussian();
      turnSlip = keep * turnSlip + push * errors.turnSlip / 2 * gaussian();
      Truth now = truth.get(i);
      double speed = now.speed / (1 - 0.02 - slip);
      double rate = now.rate / (1 - errors.turnSlip - turnSlip);
      double l = left * (speed - rate * track / 2);
      double r = right * (speed + rate * track / 2);
      double shown = (l + r) / 2;
      double turned = (r - l) / track;
      if (i % ODOMETRY_TICKS == 0) {
        double t = i * TICK;
        Odometry reading =
            new Odometry(host(t), "r/odom", "r/base", wheelX, wheelY, wheelYaw, shown, turned);
        measurements.add(new Measurement(t + 0.02, reading, -1));
      }
      wheelX += shown * TICK * Math.cos(wheelYaw);
      wheelY += shown * TICK * Math.sin(wheelYaw);
      wheelYaw += turned * TICK;
    }
  }

  private void gyro() {
    double bias = 0.005 * gaussian();
    for (int i = 0; i < truth.size(); i++) {
      bias += 2e-4 * Math.sqrt(TICK) * gaussian();
      double rate = truth.get(i).rate + bias + 0.003 * gaussian();
      measurements.add(
          new Measurement(i * TICK + 0.005, new AngularRate(host(i * TICK), "r/gyro", rate), -1));
    }
  }

  private void receivers() {
    double keep = Math.exp(-1 / 200.0);
    for (double[] each : slow) {
      each[0] = errors.biasSigma * gaussian();
      each[1] = errors.biasSigma * gaussian();
    }
    for (int s = 1; s * 100 < truth.size(); s++) {
      for (int antenna = 0; antenna < 2; antenna++) {
        for (int axis = 0; axis < 2; axis++) {
          slow[antenna][axis] =
              keep * slow[antenna][axis]
                  + errors.biasSigma * Math.sqrt(1 - keep * keep) * gaussian();
        }
        double latency = 0.16 - 0.02 * Math.log(1 - random.nextDouble());
        measurements.add(new Measurement(s + latency, fix(s, antenna), antenna));
      }
    }
  }

  private GpsFix fix(int second, int antenna) {
    Truth now = at(second);
    double cos = Math.cos(now.yaw);
    double sin = Math.sin(now.yaw);
    double arm = ANTENNAS.get(antenna).x();
    double ve = now.speed * cos - now.rate * arm * sin + 0.05 * gaussian();
    double vn = now.speed * sin + now.rate * arm * cos + 0.05 * gaussian();
    return fix(
        second,
        now.east + arm * cos + slow[antenna][0] + errors.whiteSigma * gaussian(),
        now.north + arm * sin + slow[antenna][1] + errors.whiteSigma * gaussian(),
        ve,
        vn);
  }

  /** A fix of a place and velocity, metres and metres per second, east and north. */
  GpsFix fix(double second, double east, double north, double ve, double vn) {
    double course = Math.toDegrees(Math.atan2(ve, vn));
    return new GpsFix(
        GpsFix.Mode.FIX_3D,
        frame.toGeo(new LocalPosition(east, north, 0.6)),
        utc(second),
        Math.hypot(ve, vn),
        course < 0 ? course + 360 : course,
        2,
        10,
        8);
  }
}
