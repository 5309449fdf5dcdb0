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
final class Replay {

  /** What became of a fix. */
  enum Verdict {
    /** It corrected the belief. */
    USED,
    /** Its position was too unlikely. */
    DISBELIEVED,
    /** Its position corrected the belief, but its course was too unlikely. */
    COURSE_DISBELIEVED,
    /** It is from before all that is kept. */
    TOO_LATE
  }

  private final long horizon;
  private final Belief base;
  private final Belief head;
  private final List<Event> events = new ArrayList<>();

  Replay(TrackerSettings settings) {
    this.horizon = settings.horizon().toNanos();
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

  void add(Step step) {
    head.predict(step);
    if (step.isBreach()) {
      rebase();
      return;
    }
    events.add(step);
    int old = 0;
    while (old < events.size() && events.get(old).time() < step.time() - horizon) {
      Verdict unused = apply(base, events.get(old));
      old++;
    }
    events.subList(0, old).clear();
  }

  /** Corrects by a fix that is not newer than the newest belief. */
  Verdict add(LocalFix fix) {
    if (fix.time() < base.time()) {
      return Verdict.TOO_LATE;
    }
    int at = events.size();
    while (at > 0 && events.get(at - 1).time() > fix.time()) {
      at--;
    }
    if (at < events.size() && events.get(at) instanceof Step step && step.from() < fix.time()) {
      events.set(at, step.before(fix.time()));
      events.add(at + 1, step.after(fix.time()));
      at++;
    }
    events.add(at, fix);
    Verdict verdict = Verdict.TOO_LATE;
    head.set(base);
    for (Event event : events) {
      Verdict each = apply(head, event);
      verdict = event == fix ? each : verdict;
    }
    return verdict;
  }

  private static Verdict apply(Belief belief, Event event) {
    if (event instanceof Step step) {
      belief.predict(step);
      return Verdict.USED;
    }
    LocalFix fix = (LocalFix) event;
    if (!belief.correctPosition(fix)) {
      return Verdict.DISBELIEVED;
    }
    return !belief.canUseCourse(fix) || belief.correctCourse(fix)
        ? Verdict.USED
        : Verdict.COURSE_DISBELIEVED;
  }
}
