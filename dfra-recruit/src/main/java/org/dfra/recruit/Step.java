package org.dfra.recruit;

import java.util.List;

/**
 * What follows from something that happened to a state machine.
 *
 * @param state the state from then on
 * @param actions what is to be done, in order
 */
public record Step<S, A>(S state, List<A> actions) {

  public Step {
    actions = List.copyOf(actions);
  }

  /** Nothing happened. */
  public static <S, A> Step<S, A> none(S state) {
    return new Step<>(state, List.of());
  }
}
