package org.dfra.app.benchmark.attack;

/** Keeps its core busy and leaves the robot alone: what attacks are compared with. */
public final class NeutralLoad extends AttackTask {

  private static final int STEPS = 1_000_000;

  private long state = 1;

  /** As every task is made. */
  public NeutralLoad() {}

  @Override
  protected void attack(Target target) {
    for (int i = 0; i < STEPS; i++) {
      state = state * 6_364_136_223_846_793_005L + 1_442_695_040_888_963_407L;
    }
    if (state == 0) { // never: the compiler must not drop the loop
      System.err.println("the state is 0");
    }
  }
}
