package org.dfra.recruit;

import java.util.List;

/**
 * What follows from something that happened to a state machine.
 *
 * @param state the state from then on
 * @param actions what is to be done, in order
 */
public record TransitionResult<S, A>(S state, List<A> actions) {

  public TransitionResult {
    actions = List.copyOf(actions);
  }

  /** Nothing happened. */
  public static <S, A> TransitionResult<S, A> none(S state) {
    return new TransitionResult<>(state, List.of());
  }
}
