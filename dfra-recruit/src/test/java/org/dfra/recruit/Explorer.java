package org.dfra.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * Takes a state machine to every state that it can come to, by every event in every order, and
 * makes sure of each that it ends by itself: if nothing happens any more but its own waking. To a
 * depth of 8 events in full, otherwise 5.
 *
 * @param <S> its states
 */
public final class Explorer<S> {

  /** When all begins. */
  public static final Instant BEGIN = Instant.parse("2026-11-21T00:00:00Z");

  private static final int DEPTH = Boolean.getBoolean("dfra.full") ? 8 : 5;

  /** More wakings than any end takes: a machine that wakes without end fails. */
  private static final int WAKINGS = 300;

  /** A state at a time. */
  public record Moment<S>(S state, Instant now) {}

  private final List<Function<Moment<S>, Moment<S>>> events = new ArrayList<>();
  private final Function<S, Instant> waking;
  private final BiFunction<S, Instant, S> tick;
  private final Predicate<S> isOver;

  /**
   * @param waking when a state wants to be woken; {@link Instant#MAX} where never
   * @param tick wakes it
   * @param isOver whether a state is an end
   */
  public Explorer(
      Function<S, Instant> waking, BiFunction<S, Instant, S> tick, Predicate<S> isOver) {
    this.waking = waking;
    this.tick = tick;
    this.isOver = isOver;
    events.add(this::wake);
  }

  /** Something that can happen at any time, and takes none. */
  public Explorer<S> event(BiFunction<S, Instant, S> event) {
    events.add(at -> new Moment<>(event.apply(at.state(), at.now()), at.now()));
    return this;
  }

  /** That may pass before the next event, though the machine wanted to be woken. */
  public Explorer<S> late(Duration time) {
    events.add(at -> new Moment<>(at.state(), at.now().plus(time)));
    return this;
  }

  private Moment<S> wake(Moment<S> at) {
    Instant wanted = waking.apply(at.state());
    if (wanted.equals(Instant.MAX)) {
      return at;
    }
    Instant then = wanted.isAfter(at.now()) ? wanted : at.now();
    return new Moment<>(tick.apply(at.state(), then), then);
  }

  /**
   * Every state that there is, from that one on.
   *
   * @param longest in which each has ended
   */
  public Set<S> explore(S first, Duration longest) {
    Set<Moment<S>> seen = new HashSet<>();
    List<Moment<S>> border = List.of(new Moment<>(first, BEGIN));
    seen.addAll(border);
    for (int depth = 0; depth < DEPTH; depth++) {
      List<Moment<S>> next = new ArrayList<>();
      for (Moment<S> at : border) {
        for (Function<Moment<S>, Moment<S>> event : events) {
          Moment<S> then = event.apply(at);
          if (seen.add(then)) {
            endsByItself(then, longest);
            next.add(then);
          }
        }
      }
      border = next;
    }
    Set<S> states = new HashSet<>();
    seen.forEach(each -> states.add(each.state()));
    return states;
  }

  private void endsByItself(Moment<S> from, Duration longest) {
    Moment<S> at = from;
    for (int i = 0; i < WAKINGS && !isOver.test(at.state()); i++) {
      assertThat(waking.apply(at.state())).as("%s awaits something", from).isBefore(Instant.MAX);
      at = wake(at);
    }
    assertThat(isOver.test(at.state())).as("%s ends, and not as %s", from, at).isTrue();
    assertThat(at.now())
        .as("%s has ended in time", from)
        .isBeforeOrEqualTo(from.now().plus(longest));
  }
}
