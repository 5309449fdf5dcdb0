package org.dfra.behaviors.perceptual.pose;

import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;
import org.dfra.behaviors.perceptual.pose.FilterInput.MotionIncrement;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * An extended Kalman filter's belief: a state, its covariance and the time of both.
 *
 * <pre>
 *   east, north      metres, of the robot's base
 *   yaw              radians
 *   gyro bias        radians per second: a random walk
 *   wheel scale      relative error of the wheels' distance: a slow random walk
 *   wheel yaw scale  relative error of the wheels' yaw; only without a gyro
 *   GPS biases       metres east and north, for each receiver: Gauss-Markov processes
 * </pre>
 *
 * <p>The GPS bias of a receiver without a fix yet keeps its prior: 0 with its own standard
 * deviation, uncorrelated. Confined to one thread.
 */
final class Belief {

  static final int EAST = 0;
  static final int NORTH = 1;
  static final int YAW = 2;
  static final int GYRO_BIAS = 3;
  static final int WHEEL_SCALE = 4;
  static final int WHEEL_YAW_SCALE = 5;
  static final int GPS_BIAS = 6;
  static final int SIZE = GPS_BIAS + 2 * FixPreprocessor.MAX_RECEIVERS;

  /** Random walk of the wheel scale, per root second. */
  private static final double SCALE_DRIFT = 3e-4;

  /** Random walk of the wheel yaw scale, per root second: the ground changes. */
  private static final double SPIN_DRIFT = 3e-3;

  /** Minimum standard deviation of a GPS bias, metres: a covariance must be positive. */
  private static final double LEAST = 1e-3;

  final DMatrixRMaj state = new DMatrixRMaj(SIZE, 1);
  final DMatrixRMaj covariance = new DMatrixRMaj(SIZE, SIZE);

  private final TrackerSettings settings;
  private final StateTransitionMatrix transition = new StateTransitionMatrix();
  private final MeasurementUpdate byRest = new MeasurementUpdate(SIZE, 1);
  private final FixCorrection byFix;
  private long time;
  private double speed;
  private double yawRate;

  Belief(TrackerSettings settings) {
    this.settings = settings;
    this.byFix = new FixCorrection(settings);
  }

  /** Copies another. */
  void set(Belief other) {
    state.setTo(other.state);
    covariance.setTo(other.covariance);
    time = other.time;
    speed = other.speed;
    yawRate = other.yawRate;
  }

  long time() {
    return time;
  }

  double get(int index) {
    return state.get(index);
  }

  double variance(int index) {
    return covariance.get(index, index);
  }

  /** Yaw rate in the last step, radians per second, to the left is +. */
  double yawRate() {
    return yawRate;
  }

  /** Initializes it at a pose; the other states get their priors. */
  void initialize(long at, double east, double north, double yaw) {
    time = at;
    speed = 0;
    yawRate = 0;
    state.zero();
    covariance.zero();
    state.set(EAST, east);
    state.set(NORTH, north);
    state.set(YAW, yaw);
    setUncorrelated(GYRO_BIAS, 0, settings.gyro().biasSigma());
    setUncorrelated(WHEEL_SCALE, 0, settings.wheels().scaleSigma());
    setUncorrelated(WHEEL_YAW_SCALE, 0, settings.wheels().yawScaleSigma());
    for (int slot = 0; slot < FixPreprocessor.MAX_RECEIVERS; slot++) {
      resetReceiverBias(slot);
    }
  }

  /** Sets one component of the state, uncorrelated. */
  void setUncorrelated(int index, double value, double sigma) {
    for (int i = 0; i < SIZE; i++) {
      covariance.set(index, i, 0);
      covariance.set(i, index, 0);
    }
    state.set(index, value);
    covariance.set(index, index, sigma * sigma);
  }

  /** Resets the GPS bias of a receiver to its prior. */
  void resetReceiverBias(int slot) {
    setUncorrelated(GPS_BIAS + 2 * slot, 0, slowSigma());
    setUncorrelated(GPS_BIAS + 2 * slot + 1, 0, slowSigma());
  }

  private double slowSigma() {
    return Math.max(LEAST, settings.gps().biasSigma());
  }

  /** Inflates the covariance of position, metres, and yaw, radians. */
  void inflate(double metres, double radians) {
    covariance.add(EAST, EAST, metres * metres);
    covariance.add(NORTH, NORTH, metres * metres);
    covariance.add(YAW, YAW, radians * radians);
  }

  /** Predicts by a motion increment. */
  void predict(MotionIncrement step) {
    double dt = step.seconds();
    boolean rests =
        step.isRobotStationary(
            get(GYRO_BIAS), Math.sqrt(variance(GYRO_BIAS)), settings.gyro().noiseDensity());
    double turn = turn(step, dt, rests);
    double middle = state.get(YAW) + turn / 2;
    double cos = Math.cos(middle);
    double sin = Math.sin(middle);
    double way = step.distance() * (1 + state.get(WHEEL_SCALE));
    double keep = Math.exp(-dt / settings.gps().biasCorrelationTime());
    transition.clear(keep);
    transition.setPositionTerms(YAW, -way * sin, way * cos);
    transition.setPositionTerms(WHEEL_SCALE, step.distance() * cos, step.distance() * sin);
    if (step.hasGyro() && !rests) {
      transition.setYawTerms(-dt, 0);
      transition.setPositionTerms(GYRO_BIAS, way * sin * dt / 2, -way * cos * dt / 2);
    }
    if (!step.hasGyro()) {
      double change = rests ? 0 : step.wheelYaw();
      transition.setYawTerms(0, change);
      transition.setPositionTerms(WHEEL_YAW_SCALE, -way * sin * change / 2, way * cos * change / 2);
    }
    for (int i = GPS_BIAS; i < SIZE; i++) {
      state.set(i, state.get(i) * keep);
    }
    state.add(EAST, 0, way * cos);
    state.add(NORTH, 0, way * sin);
    state.set(YAW, Math.IEEEremainder(state.get(YAW) + turn, 2 * Math.PI));
    transition.apply(covariance);
    addNoise(step, dt, rests, turn, keep, cos, sin);
    MeasurementUpdate.symmetrize(covariance);
    time = step.time();
    speed = dt > 0 ? way / dt : 0;
    yawRate = dt > 0 ? turn / dt : 0;
    if (rests && step.hasGyro() && dt > 0) {
      learnTurn(step.gyroYaw() / dt, dt);
    }
  }

  private double turn(MotionIncrement step, double dt, boolean rests) {
    if (rests) {
      return 0;
    }
    return step.hasGyro()
        ? step.gyroYaw() - state.get(GYRO_BIAS) * dt
        : step.wheelYaw() * (1 + state.get(WHEEL_YAW_SCALE));
  }

  private void addNoise(
      MotionIncrement step,
      double dt,
      boolean rests,
      double turn,
      double keep,
      double cos,
      double sin) {
    TrackerSettings.WheelErrors wheels = settings.wheels();
    TrackerSettings.GyroErrors gyro = settings.gyro();
    double lost = step.distanceSigma() * step.distanceSigma();
    double along =
        wheels.longitudinalSlip() * wheels.longitudinalSlip() * Math.abs(step.distance()) + lost;
    double side = wheels.lateralSlip() * wheels.lateralSlip() * Math.abs(step.distance()) + lost;
    covariance.add(EAST, EAST, along * cos * cos + side * sin * sin);
    covariance.add(NORTH, NORTH, along * sin * sin + side * cos * cos);
    covariance.add(EAST, NORTH, (along - side) * sin * cos);
    covariance.add(NORTH, EAST, (along - side) * sin * cos);
    double angle = Math.abs(turn);
    if (step.hasGyro()) {
      double noise = rests ? 0 : gyro.noiseDensity() * gyro.noiseDensity() * dt;
      covariance.add(YAW, YAW, noise + gyro.scaleNoise() * gyro.scaleNoise() * angle);
    } else if (!rests) {
      covariance.add(
          YAW,
          YAW,
          wheels.yawSlip() * wheels.yawSlip() * angle
              + wheels.yawRandomWalk() * wheels.yawRandomWalk() * dt
              + step.yawSigma() * step.yawSigma());
    }
    covariance.add(GYRO_BIAS, GYRO_BIAS, gyro.biasRandomWalk() * gyro.biasRandomWalk() * dt);
    covariance.add(WHEEL_SCALE, WHEEL_SCALE, SCALE_DRIFT * SCALE_DRIFT * dt);
    if (!step.hasGyro()) {
      covariance.add(WHEEL_YAW_SCALE, WHEEL_YAW_SCALE, SPIN_DRIFT * SPIN_DRIFT * dt);
    }
    double fresh = slowSigma() * slowSigma() * (1 - keep * keep);
    for (int i = GPS_BIAS; i < SIZE; i++) {
      covariance.add(i, i, fresh);
    }
  }

  /** Corrects the gyro bias: the robot is stationary. */
  private void learnTurn(double rate, double dt) {
    double noise = settings.gyro().noiseDensity();
    byRest.jacobian.zero();
    byRest.jacobian.set(0, GYRO_BIAS, 1);
    byRest.innovation.set(0, 0, rate - state.get(GYRO_BIAS));
    byRest.noise.set(0, 0, noise * noise / dt);
    byRest.apply(state, covariance, Double.POSITIVE_INFINITY);
  }

  /** Corrects by a fix's position; false if the gate rejected it. */
  boolean correctPosition(LocalFix fix) {
    return byFix.position(fix, state, covariance);
  }

  /** Whether the fix's course is usable for the yaw, given the last step. */
  boolean canUseCourse(LocalFix fix) {
    return !Double.isNaN(fix.course())
        && Math.abs(speed) > FixWindow.MIN_COURSE_SPEED
        && Math.abs(yawRate) < FixWindow.MAX_COURSE_YAW_RATE;
  }

  /** Corrects by a fix's course; false if the gate rejected it. */
  boolean correctCourse(LocalFix fix) {
    return byFix.course(fix, fix.antennaDirection(speed, yawRate), state, covariance);
  }

  /** Standard deviation of the position along its worst direction, metres. */
  double positionSigma() {
    double mean = (variance(EAST) + variance(NORTH)) / 2;
    double half = (variance(EAST) - variance(NORTH)) / 2;
    return Math.sqrt(Math.max(0, mean + Math.hypot(half, covariance.get(EAST, NORTH))));
  }

  double yawSigma() {
    return Math.sqrt(Math.max(0, variance(YAW)));
  }

  /** Whether all numbers are finite and all variances positive. */
  boolean isValid() {
    for (int i = 0; i < SIZE; i++) {
      if (!Double.isFinite(state.get(i)) || !(variance(i) > 0)) {
        return false;
      }
    }
    return Double.isFinite(CommonOps_DDRM.elementSum(covariance));
  }
}
