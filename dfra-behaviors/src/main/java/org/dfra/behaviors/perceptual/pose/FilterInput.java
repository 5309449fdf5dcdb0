package org.dfra.behaviors.perceptual.pose;

/** An input that predicts or corrects a belief, in the order of time. */
sealed interface FilterInput permits MotionIncrement, LocalFix {

  /** Its end, nanoseconds by the robot's clock. */
  long time();
}
