package org.dfra.sim.device.pantilt;

/**
 * One axis driven by a step motor: a ramp up, a constant speed, a ramp down, all of them changed on
 * the way when it is told so. Positions are the unit's own. Moves in steps of a millisecond, so
 * where it is does not depend on how often it is looked at.
 */
final class StepMotor {

  static final double STEP_SECONDS = 0.001;

  private static final int BASE_SPEED = 57; // positions/s, from and to standing without a ramp
  private static final int SLOWEST = 31; // positions/s
  private static final int FASTEST = 2902; // positions/s
  private static final int USUAL_SPEED = 1000; // positions/s
  private static final int ACCELERATION = 2000; // positions/s²
  private static final int BEYOND = 60; // positions from a limit to the end of the way

  private final char letter;
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
   * @param letter what its commands begin with
   * @param name in the unit's sentences
   * @param least position at the right or lower limit
   * @param most position at the other
   */
  StepMotor(char letter, String name, int least, int most) {
    this.letter = letter;
    this.name = name;
    this.least = least;
    this.most = most;
  }

  char letter() {
    return letter;
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

  /** Where it is, to the nearest position. */
  int position() {
    return (int) Math.rint(position);
  }

  /** Where it is, between two positions too. */
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

  /** Whether targets beyond the limits are refused. */
  void limit(boolean whether) {
    limited = whether;
  }

  /** Whether it may be told to go there. */
  boolean isReachable(int there) {
    return !limited || (there >= least && there <= most);
  }

  void goTo(int there) {
    target = there;
  }

  /** Comes to stand as fast as it may. */
  void halt() {
    double way = velocity * Math.abs(velocity) / (2 * acceleration);
    target = (int) Math.rint(position + (Math.abs(velocity) <= BASE_SPEED ? 0 : way));
  }

  /** Whether it ran against its end since this was asked last; it stands there now. */
  boolean pollLimitHit() {
    boolean was = hit;
    hit = false;
    return was;
  }

  /** Moves on by a millisecond. */
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
