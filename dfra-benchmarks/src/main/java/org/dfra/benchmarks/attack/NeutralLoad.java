package org.dfra.benchmarks.attack;

/** Keeps its core busy and does not access the robot: the baseline for the attacks. */
final class NeutralLoad extends AttackTask {

  private static final int STEPS = 1_000_000;

  private long state = 1;

  /** Called by {@code TaskMain} by reflection. */
  public NeutralLoad() {}

  @Override
  protected void attack(Target target) {
    for (int i = 0; i < STEPS; i++) {
      state = state * 6_364_136_223_846_793_005L + 1_442_695_040_888_963_407L;
    }
    if (state == 0) { // never true: prevents dead-code elimination of the loop
      System.err.println("the state is 0");
    }
  }
}
