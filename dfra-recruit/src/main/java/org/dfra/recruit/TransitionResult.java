package org.dfra.recruit;

import java.util.List;

/**
 * The result of an event in a state machine.
 *
 * @param state the state from then on
 * @param actions to execute, in order
 */
public record TransitionResult<S, A>(S state, List<A> actions) {

  public TransitionResult {
    actions = List.copyOf(actions);
  }

  /** No change. */
  public static <S, A> TransitionResult<S, A> none(S state) {
    return new TransitionResult<>(state, List.of());
  }
}
