package org.dfra.behaviors.perceptual.pose;

import java.util.ArrayList;
import java.util.List;
import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;
import org.dfra.behaviors.perceptual.pose.FilterInput.MotionIncrement;

/**
 * A belief that can be corrected in the past. It stores an old belief, the base, and all inputs
 * since in the order of time. It inserts a late fix at its own time, splits the motion increment
 * there, and replays all later inputs: the result equals that of fixes without delay.
 *
 * <pre>
 *   base --step--step--step-.- fix -.-step-- fix --step--&gt; head
 *   horizon ago             split                          now
 * </pre>
 */
final class DelayedFixFilter {

  /** Result of a fix. */
  enum FixOutcome {
    /** It corrected the belief. */
    USED,
    /** The gate rejected its position. */
    REJECTED,
    /** Its position corrected the belief, but the gate rejected its course. */
    COURSE_REJECTED,
    /** It is older than all stored inputs. */
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

  /** The newest belief. After changing it, call {@link #rebase()}. */
  Belief head() {
    return head;
  }

  /** Makes the newest belief the base: nothing before it can be corrected any more. */
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
