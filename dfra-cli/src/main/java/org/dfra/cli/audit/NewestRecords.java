package org.dfra.cli.audit;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;

/**
 * Merges the records of several streams by time, and keeps the newest. The order within a stream
 * stays as it is, also where its clock was set back: there a record counts as late as the one
 * before.
 */
final class NewestRecords {

  private static final Comparator<Dated> ORDER =
      Comparator.comparing(Dated::time)
          .thenComparing(each -> each.view().stream())
          .thenComparing(each -> each.view().number());

  /** A record with the time by which it is merged. */
  private record Dated(Instant time, RecordView view) {}

  private final int most;
  private final PriorityQueue<Dated> kept = new PriorityQueue<>(ORDER);
  private final Map<String, Instant> latest = new HashMap<>();
  private long all;

  NewestRecords(int most) {
    this.most = most;
  }

  /** Adds a record; those of a stream come in order. */
  void add(RecordView view) {
    all++;
    Instant time =
        latest.merge(view.stream(), view.time(), (one, two) -> one.isAfter(two) ? one : two);
    kept.add(new Dated(time, view));
    if (kept.size() > most) {
      kept.remove();
    }
  }

  /** How many were added. */
  long all() {
    return all;
  }

  /** The newest, the earliest of them first; they are not kept any longer. */
  List<RecordView> take() {
    List<RecordView> ordered = new ArrayList<>();
    while (!kept.isEmpty()) {
      ordered.add(kept.remove().view());
    }
    return ordered;
  }
}
