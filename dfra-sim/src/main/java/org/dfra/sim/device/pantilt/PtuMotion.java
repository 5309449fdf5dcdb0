package org.dfra.sim.device.pantilt;

import java.util.ArrayDeque;

/** A motion that the unit completes before it executes the next command. */
final class PtuMotion {

  private final StepMotor pan;
  private final StepMotor tilt;
  private final ArrayDeque<Runnable> legs = new ArrayDeque<>();

  private PtuMotion(StepMotor pan, StepMotor tilt) {
    this.pan = pan;
    this.tilt = tilt;
  }

  /** Until both axes reach their commanded positions. */
  static PtuMotion ending(StepMotor pan, StepMotor tilt) {
    return new PtuMotion(pan, tilt);
  }

  /** Each given axis to its one limit, to the other, and to 0; one axis after the other. */
  static PtuMotion reset(StepMotor... motors) {
    PtuMotion motion = new PtuMotion(motors[0], motors[motors.length - 1]);
    for (StepMotor motor : motors) {
      motion.legs.add(() -> motor.goTo(motor.minPosition()));
      motion.legs.add(() -> motor.goTo(motor.maxPosition()));
      motion.legs.add(() -> motor.goTo(0));
    }
    return motion;
  }

  /** Starts the next leg when one has ended; returns whether all have ended. */
  boolean isOver() {
    if (pan.isMoving() || tilt.isMoving()) {
      return false;
    }
    Runnable next = legs.poll();
    if (next == null) {
      return true;
    }
    next.run();
    return false;
  }
}
