package org.dfra.sim.physics;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * The wheels of a robot on blocks: they follow their controller exactly, with its accelerations,
 * and do not touch the ground. Sufficient to test a controller without a world.
 */
public final class IdealDrivetrain implements DrivetrainPhysics {

  /** Metres per second squared, or radians per second squared, deceleration of the brakes. */
  public static final double BRAKING = 20;

  /** Slower counts as stopped: 1 mm/s, 1 mrad/s. */
  private static final double STOPPED_RATE = 1e-3;

  /** Motion about or along one axis: from one speed to another, with constant acceleration. */
  private static final class Ramp {
    private Instant begin;
    private double position;
    private double speed;
    private double target;
    private double acceleration = BRAKING;
    private @Nullable Instant stoppedAt; // since when it was stopped at its begin

    Ramp(Instant begin) {
      this.begin = begin;
      this.stoppedAt = begin;
    }

    /** Since when it is stopped; null if it moves or is commanded to move. */
    @Nullable Instant stoppedSince(Instant now) {
      if (Math.abs(target) > STOPPED_RATE) {
        return null;
      }
      if (stoppedAt != null) {
        return stoppedAt;
      }
      double left = Math.max(0, Math.abs(speed) - STOPPED_RATE) / acceleration;
      Instant stands = begin.plusNanos((long) Math.ceil(left * 1e9));
      return stands.isAfter(now) ? null : stands;
    }

    /** Seconds it lasts. */
    double length() {
      return Math.abs(target - speed) / acceleration;
    }

    double speed(double seconds) {
      double change = Math.min(acceleration * seconds, Math.abs(target - speed));
      return speed + Math.copySign(change, target - speed);
    }

    double position(double seconds) {
      double ramp = Math.min(seconds, length());
      return position + (speed + speed(ramp)) / 2 * ramp + target * (seconds - ramp);
    }

    void retarget(Instant now, double nextTarget, double nextAcceleration) {
      stoppedAt = stoppedSince(now);
      double seconds = seconds(now);
      position = position(seconds);
      speed = speed(seconds);
      begin = now;
      target = nextTarget;
      acceleration = nextAcceleration;
    }

    double seconds(Instant now) {
      return Duration.between(begin, now).toNanos() / 1e9;
    }
  }

  @GuardedBy("this")
  private final Ramp along;

  @GuardedBy("this")
  private final Ramp about;

  @GuardedBy("this")
  private Instant last;

  @GuardedBy("this")
  private boolean braked;

  /** Wheels that are stopped at {@code begin}. */
  public IdealDrivetrain(Instant begin) {
    along = new Ramp(begin);
    about = new Ramp(begin);
    last = begin;
  }

  @Override
  public synchronized void drive(
      Instant time, double speed, double turnRate, double acceleration, double turnAcceleration) {
    if (!(acceleration > 0 && turnAcceleration > 0)) {
      throw new IllegalArgumentException(
          "accelerations "
              + acceleration
              + " m/s² and "
              + turnAcceleration
              + " rad/s² must both be above 0");
    }
    Instant now = pass(time);
    if (!braked) {
      along.retarget(now, speed, acceleration);
      about.retarget(now, turnRate, turnAcceleration);
    }
  }

  @Override
  public synchronized void brake(Instant time, boolean set) {
    Instant now = pass(time);
    if (set && !braked) {
      along.retarget(now, 0, BRAKING);
      about.retarget(now, 0, BRAKING);
    }
    braked = set;
  }

  @Override
  public synchronized Travel travel(Instant time) {
    Instant now = pass(time);
    double onAlong = along.seconds(now);
    double onAbout = about.seconds(now);
    return new Travel(
        along.position(onAlong),
        about.position(onAbout),
        along.speed(onAlong),
        about.speed(onAbout));
  }

  /** Since when they are stopped, that is slower than 1 mm/s and 1 mrad/s; null if they move. */
  public synchronized @Nullable Instant stoppedSince(Instant time) {
    Instant now = pass(time);
    @Nullable Instant first = along.stoppedSince(now);
    @Nullable Instant second = about.stoppedSince(now);
    if (first == null || second == null) {
      return null;
    }
    return first.isAfter(second) ? first : second;
  }

  /** Time never decreases. */
  @GuardedBy("this")
  private Instant pass(Instant time) {
    last = time.isAfter(last) ? time : last;
    return last;
  }
}
