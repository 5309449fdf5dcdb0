package org.dfra.sim.device.pantilt;

/**
 * One axis driven by a step motor: a ramp up, a constant speed, a ramp down. Commands can change
 * all three during a motion. Positions are in the unit's own counts. It moves in steps of a
 * millisecond, so its position does not depend on how often it is polled.
 */
final class StepperMotor {

  static final double STEP_SECONDS = 0.001;

  private static final int BASE_SPEED = 57; // positions/s, start and stop speed without a ramp
  private static final int SLOWEST = 31; // positions/s
  private static final int FASTEST = 2902; // positions/s
  private static final int USUAL_SPEED = 1000; // positions/s
  private static final int ACCELERATION = 2000; // positions/s²
  private static final int BEYOND = 60; // positions from a limit to the end stop

  private final char envelope;
  private final String name;
  private final int least;
  private final int most;
  private int speed = USUAL_SPEED;
  private int acceleration = ACCELERATION;
  private int target;
  private double position;
  private double velocity; // positions/s
  private boolean limited = true;
  private boolean hit;

  /**
   * @param envelope first letter of its commands
   * @param name in the unit's verbose replies
   * @param least position at the right or lower limit
   * @param most position at the other
   */
  StepperMotor(char envelope, String name, int least, int most) {
    this.envelope = envelope;
    this.name = name;
    this.least = least;
    this.most = most;
  }

  char letter() {
    return envelope;
  }

  String name() {
    return name;
  }

  int minPosition() {
    return least;
  }

  int maxPosition() {
    return most;
  }

  int minSpeed() {
    return SLOWEST;
  }

  int maxSpeed() {
    return FASTEST;
  }

  int baseSpeed() {
    return BASE_SPEED;
  }

  int speed() {
    return speed;
  }

  int acceleration() {
    return acceleration;
  }

  int target() {
    return target;
  }

  /** Current position, rounded. */
  int position() {
    return (int) Math.rint(position);
  }

  /** Current position, with fraction. */
  double exactPosition() {
    return position;
  }

  boolean isMoving() {
    return velocity != 0 || position != target;
  }

  void setSpeed(int positionsPerSecond) {
    speed = positionsPerSecond;
  }

  void setAcceleration(int positionsPerSecondSquared) {
    acceleration = positionsPerSecondSquared;
  }

  /** Sets whether it rejects targets beyond the limits. */
  void limit(boolean whether) {
    limited = whether;
  }

  /** Whether it accepts this target. */
  boolean isReachable(int there) {
    return !limited || (there >= least && there <= most);
  }

  void goTo(int there) {
    target = there;
  }

  /** Stops at maximum deceleration. */
  void halt() {
    double way = velocity * Math.abs(velocity) / (2 * acceleration);
    target = (int) Math.rint(position + (Math.abs(velocity) <= BASE_SPEED ? 0 : way));
  }

  /** Whether it ran against its end stop since the last call; it is stopped there now. */
  boolean pollLimitHit() {
    boolean was = hit;
    hit = false;
    return was;
  }

  /** Moves by one millisecond. */
  void step() {
    double left = target - position;
    if (left == 0 && velocity == 0) {
      return;
    }
    double mostSpeed = Math.min(speed, Math.sqrt(2 * acceleration * Math.abs(left)));
    double targetVelocity = Math.copySign(Math.max(mostSpeed, Math.min(BASE_SPEED, speed)), left);
    velocity = ramped(targetVelocity);
    double way = velocity * STEP_SECONDS;
    boolean arrives = Math.abs(way) >= Math.abs(left) && Math.signum(way) == Math.signum(left);
    if (arrives && Math.abs(velocity) <= BASE_SPEED + acceleration * STEP_SECONDS) {
      position = target;
      velocity = 0;
    } else {
      position += way;
      stopAtTheEnd();
    }
  }

  private double ramped(double targetVelocity) {
    double change = acceleration * STEP_SECONDS;
    boolean reverses = velocity != 0 && Math.signum(targetVelocity) != Math.signum(velocity);
    if (reverses) {
      double slower = Math.abs(velocity) - change;
      return slower <= BASE_SPEED
          ? Math.copySign(BASE_SPEED, targetVelocity)
          : slower * Math.signum(velocity);
    }
    double from = Math.max(Math.abs(velocity), BASE_SPEED);
    double to = Math.abs(targetVelocity);
    double next = to > from ? Math.min(to, from + change) : Math.max(to, from - change);
    return Math.copySign(to < BASE_SPEED ? to : next, targetVelocity);
  }

  private void stopAtTheEnd() {
    if (position > most + BEYOND || position < least - BEYOND) {
      position = position > 0 ? most + BEYOND : least - BEYOND;
      target = (int) position;
      velocity = 0;
      hit = true;
    }
  }
}
