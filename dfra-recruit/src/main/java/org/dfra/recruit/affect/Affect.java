package org.dfra.recruit.affect;

/**
 * A scalar that rises while others ask for help, and at 1 moves the robot to give it. Confined to
 * its agent.
 */
public interface Affect {

  /** How strong it is, 0 to 1. */
  double level();

  /** It was asked, capable and free. */
  void stimulate(Stimulus stimulus);

  /** It was chosen to help. */
  void atone();

  /** Another was chosen, or nobody is needed any more. */
  void relieve();

  /**
   * As strong as it was when its process died.
   *
   * @param level 0 to 1
   */
  void restore(double level);

  /** Whether it moves the robot to help. */
  default boolean isTriggered() {
    return level() >= 1;
  }
}
