package org.dfra.core.audit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The heads that a member keeps of one stream. Immutable.
 *
 * @param chain by ascending number; the last one is the newest
 * @param fork one that contradicts one of the chain; empty if none was received
 */
record StreamHeads(List<ReceivedHead> chain, Optional<ReceivedHead> fork) {

  static final StreamHeads NONE = new StreamHeads(List.of(), Optional.empty());

  StreamHeads {
    chain = List.copyOf(chain);
  }

  ReceivedHead newest() {
    return chain.get(chain.size() - 1);
  }

  /** All of them, by ascending number, the fork last. */
  List<ReceivedHead> all() {
    List<ReceivedHead> all = new ArrayList<>(chain);
    fork.ifPresent(all::add);
    return all;
  }

  /** With one more line of a file. */
  StreamHeads loaded(ReceivedHead next) {
    return chain.isEmpty() || next.number() > newest().number()
        ? new StreamHeads(added(chain, next), fork)
        : new StreamHeads(chain, Optional.of(next));
  }

  private static List<ReceivedHead> added(List<ReceivedHead> to, ReceivedHead next) {
    List<ReceivedHead> all = new ArrayList<>(to);
    all.add(next);
    return all;
  }

  /** What becomes of a head. */
  HeadStore.Outcome outcome(KeptHead head) {
    if (chain.stream().anyMatch(each -> each.contradicts(head))) {
      return HeadStore.Outcome.CONTRADICTION;
    }
    return chain.isEmpty() || head.head().number() > newest().number()
        ? HeadStore.Outcome.KEPT
        : HeadStore.Outcome.KNOWN;
  }

  /** With one more head, if it has to be kept. */
  StreamHeads with(ReceivedHead next) {
    return switch (outcome(next.kept())) {
      case CONTRADICTION -> fork.isPresent() ? this : new StreamHeads(chain, Optional.of(next));
      case KEPT -> new StreamHeads(extended(next), fork);
      default -> this;
    };
  }

  /** The newest one gives way, unless it was received long after the one before it. */
  private List<ReceivedHead> extended(ReceivedHead next) {
    List<ReceivedHead> all = new ArrayList<>(chain);
    int size = all.size();
    if (size > 1
        && all.get(size - 2)
            .received()
            .plus(HeadStore.ANCHOR_INTERVAL)
            .isAfter(all.get(size - 1).received())) {
      all.remove(size - 1);
    }
    all.add(next);
    return all.subList(Math.max(0, all.size() - HeadStore.MOST_OF_STREAM), all.size());
  }
}
