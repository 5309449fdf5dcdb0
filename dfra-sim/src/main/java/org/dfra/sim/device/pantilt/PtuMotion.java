package org.dfra.sim.device.pantilt;

import java.util.ArrayDeque;

/** A motion that the unit ends before it obeys again. */
final class PtuMotion {

  private final StepMotor pan;
  private final StepMotor tilt;
  private final ArrayDeque<Runnable> legs = new ArrayDeque<>();

  private PtuMotion(StepMotor pan, StepMotor tilt) {
    this.pan = pan;
    this.tilt = tilt;
  }

  /** Until both axes are where they were told to be. */
  static PtuMotion ending(StepMotor pan, StepMotor tilt) {
    return new PtuMotion(pan, tilt);
  }

  /** Each axis that is given to its one limit, to the other, and to 0; one after the other. */
  static PtuMotion reset(StepMotor... motors) {
    PtuMotion motion = new PtuMotion(motors[0], motors[motors.length - 1]);
    for (StepMotor motor : motors) {
      motion.legs.add(() -> motor.goTo(motor.minPosition()));
      motion.legs.add(() -> motor.goTo(motor.maxPosition()));
      motion.legs.add(() -> motor.goTo(0));
    }
    return motion;
  }

  /** Begins the next leg where one has ended; whether all have. */
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
