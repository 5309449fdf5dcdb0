package org.dfra.recruit.affect;

/**
 * A scalar that rises with others' calls for help; at its threshold, 1, the robot offers help.
 * Confined to its agent.
 */
public interface Affect {

  /** Its level, 0 to 1. */
  double level();

  /** A call for help was received while the robot was capable and free. */
  void stimulate(Stimulus stimulus);

  /** The robot was chosen to help. */
  void onHelping();

  /** Another robot was chosen, or no help is needed any more. */
  void onRelease();

  /**
   * Restores its level after a restart of its process.
   *
   * @param level 0 to 1
   */
  void restore(double level);

  /** Whether it has reached its threshold. */
  default boolean isTriggered() {
    return level() >= 1;
  }
}
