package org.dfra.behaviors.perceptual.pose;

/** What moves or corrects a belief, in the order of time. */
sealed interface FilterInput permits MotionIncrement, LocalFix {

  /** When it is over, nanoseconds by the robot's clock. */
  long time();
}
