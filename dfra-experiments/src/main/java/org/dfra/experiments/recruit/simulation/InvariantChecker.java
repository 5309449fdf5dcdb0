package org.dfra.experiments.recruit.simulation;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.dfra.agent.RequesterPhase;
import org.dfra.recruit.agent.AgentSnapshot;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.requester.RequesterState;
import org.dfra.recruit.responder.ResponderState;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Monitors the states of all agents together, and counts violations: a second helper of a
 * requester, and a helper that its requester does not expect. Thread-safe.
 */
final class InvariantChecker {

  private static final long GRACE_NANOS = 2_000_000_000;

  private record SuspectedOrphan(String robot, Conversation in) {}

  private final Scheduler time;
  private final Map<String, AgentSnapshot> known = new HashMap<>();
  private final Map<String, Set<String>> helpers = new HashMap<>(); // by requester
  private final Set<SuspectedOrphan> suspects = new HashSet<>();
  private final Set<SuspectedOrphan> judged = new HashSet<>(); // counted
  private int doubles;
  private int orphans;

  InvariantChecker(Scheduler time) {
    this.time = time;
  }

  synchronized int doubles() {
    return doubles;
  }

  synchronized int orphans() {
    return orphans;
  }

  /** Updates the state of a robot. */
  synchronized void update(String robot, AgentSnapshot snapshot) {
    known.put(robot, snapshot);
    ResponderState responder = snapshot.responder();
    helpers.values().forEach(each -> each.remove(robot));
    Conversation in = responder.conversation();
    if (in != null && responder.phase().isCommitted()) {
      Set<String> all = helpers.computeIfAbsent(in.requester(), unused -> new HashSet<>());
      all.add(robot);
    }
    for (String each : known.keySet()) {
      suspect(each);
    }
  }

  /** Counts a robot that starts to help as the second one. */
  synchronized void committed(String requester) {
    if (helpers.getOrDefault(requester, Set.of()).size() > 1) {
      doubles++;
    }
  }

  private void suspect(String robot) {
    SuspectedOrphan now = orphan(robot);
    if (now != null && suspects.add(now)) {
      var unused = time.after(GRACE_NANOS, () -> judge(now));
    }
  }

  private synchronized void judge(SuspectedOrphan suspect) {
    suspects.remove(suspect);
    if (suspect.equals(orphan(suspect.robot())) && judged.add(suspect)) {
      orphans++;
    }
  }

  /** The conversation in which no requester expects it; null where one does. */
  private @Nullable SuspectedOrphan orphan(String robot) {
    AgentSnapshot snapshot = known.get(robot);
    Conversation in = snapshot == null ? null : snapshot.responder().conversation();
    if (in == null || snapshot == null || !snapshot.responder().phase().isCommitted()) {
      return null;
    }
    AgentSnapshot requester = known.get(in.requester());
    return requester != null && countsOn(requester.requester(), in, robot)
        ? null
        : new SuspectedOrphan(robot, in);
  }

  private static boolean countsOn(RequesterState state, Conversation in, String robot) {
    return state.conversation().equals(in)
        && state.phase() != RequesterPhase.IDLE
        && state.winner() != null
        && state.winner().robot().equals(robot);
  }

  /** The run has ended, and all had time to become idle: a robot that is not free is an orphan. */
  synchronized void end() {
    for (AgentSnapshot snapshot : known.values()) {
      if (snapshot.responder().phase().isCommitted()) {
        orphans++;
      }
    }
  }
}
