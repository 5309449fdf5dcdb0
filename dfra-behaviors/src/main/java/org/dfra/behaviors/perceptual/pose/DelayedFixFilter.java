package org.dfra.behaviors.perceptual.pose;

import java.util.ArrayList;
import java.util.List;

/**
 * A belief that can be corrected in the past. It keeps an old belief, the base, and all that
 * happened since in the order of time. A fix that comes late is put where it belongs, its step cut
 * in two, and everything after it is gone through again: the outcome is that of fixes that are
 * never late.
 *
 * <pre>
 *   base --step--step--step-.- fix -.-step-- fix --step--&gt; head
 *   horizon ago             cut in two                     now
 * </pre>
 */
final class DelayedFixFilter {

  /** What became of a fix. */
  enum FixOutcome {
    /** It corrected the belief. */
    USED,
    /** Its position was too unlikely. */
    REJECTED,
    /** Its position corrected the belief, but its course was too unlikely. */
    COURSE_REJECTED,
    /** It is from before all that is kept. */
    TOO_LATE
  }

  private final long horizon;
  private final Belief base;
  private final Belief head;
  private final List<FilterInput> events = new ArrayList<>();

  DelayedFixFilter(TrackerSettings settings) {
    this.horizon = settings.maxFixDelay().toNanos();
    this.base = new Belief(settings);
    this.head = new Belief(settings);
  }

  /** The newest belief. Who changes it calls {@link #rebase()}. */
  Belief head() {
    return head;
  }

  /** Makes the newest belief the only one: nothing before it can be corrected any more. */
  void rebase() {
    base.set(head);
    events.clear();
  }

  void add(MotionIncrement step) {
    head.predict(step);
    if (step.isClockJump()) {
      rebase();
      return;
    }
    events.add(step);
    int old = 0;
    while (old < events.size() && events.get(old).time() < step.time() - horizon) {
      FixOutcome unused = apply(base, events.get(old));
      old++;
    }
    events.subList(0, old).clear();
  }

  /** Corrects by a fix that is not newer than the newest belief. */
  FixOutcome add(LocalFix fix) {
    if (fix.time() < base.time()) {
      return FixOutcome.TOO_LATE;
    }
    int at = events.size();
    while (at > 0 && events.get(at - 1).time() > fix.time()) {
      at--;
    }
    if (at < events.size()
        && events.get(at) instanceof MotionIncrement step
        && step.from() < fix.time()) {
      events.set(at, step.before(fix.time()));
      events.add(at + 1, step.after(fix.time()));
      at++;
    }
    events.add(at, fix);
    FixOutcome verdict = FixOutcome.TOO_LATE;
    head.set(base);
    for (FilterInput event : events) {
      FixOutcome each = apply(head, event);
      verdict = event == fix ? each : verdict;
    }
    return verdict;
  }

  private static FixOutcome apply(Belief belief, FilterInput event) {
    if (event instanceof MotionIncrement step) {
      belief.predict(step);
      return FixOutcome.USED;
    }
    LocalFix fix = (LocalFix) event;
    if (!belief.correctPosition(fix)) {
      return FixOutcome.REJECTED;
    }
    return !belief.canUseCourse(fix) || belief.correctCourse(fix)
        ? FixOutcome.USED
        : FixOutcome.COURSE_REJECTED;
  }
}
