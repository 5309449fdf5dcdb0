package org.dfra.core.policy;

/**
 * Observes the decisions of a {@link PolicyGuard}. It logs those and notifies operators of those
 * whose {@link Obligations} say so.
 */
@FunctionalInterface
public interface DecisionListener {

  /**
   * Called for each decision that {@linkplain #concerns concerns} it, on the thread of the call,
   * before the call runs. Thread-safe; it returns at once. If it throws, the call does not run.
   */
  void onDecision(DecisionRecord decision);

  /**
   * Whether it observes decisions with these obligations. If not, it is not called for them.
   * Thread-safe; it returns at once.
   */
  default boolean concerns(Obligations obligations) {
    return true;
  }

  /** A listener that calls this one, and then another. */
  default DecisionListener andThen(DecisionListener other) {
    return decision -> {
      onDecision(decision);
      other.onDecision(decision);
    };
  }
}
