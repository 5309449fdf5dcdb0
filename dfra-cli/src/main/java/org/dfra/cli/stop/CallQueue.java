package org.dfra.cli.stop;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import org.dfra.river.access.NumericAddress;
import org.dfra.river.call.PeerAddress;
import org.jspecify.annotations.Nullable;

/**
 * The calls of one lookup service, those that wait by host and robot.
 *
 * <p>Not thread-safe: {@link FairCallScheduler} guards it and its calls.
 */
final class CallQueue {

  /** A call of a proxy. */
  static final class Call {
    final UUID registrar;
    final @Nullable PeerAddress peer;
    final String robot;
    final Callable<Outcome> code;
    final CompletableFuture<Outcome> answer = new CompletableFuture<>();
    boolean answersProbe;
    boolean begun;
    boolean hasPlace;
    @Nullable Thread runner; // while the call runs

    Call(UUID registrar, @Nullable PeerAddress peer, String robot, Callable<Outcome> code) {
      this.registrar = registrar;
      this.peer = peer;
      this.robot = robot;
      this.code = code;
    }

    /** Hosts without a numeric address are one: a sender can invent any number of names. */
    String host() {
      return peer == null || NumericAddress.parse(peer.host()) == null ? "" : peer.host();
    }
  }

  private final WaitingCalls answering = new WaitingCalls(); // peers answer connection attempts
  private final WaitingCalls others = new WaitingCalls();
  int places;
  int unansweredPlaces; // of these, of calls whose peers did not answer before
  int underWay;

  /** Adds a call behind the others of its robot. */
  void add(Call call) {
    waiting(call).of(call).add(call);
  }

  /** Adds a call again that could not start. */
  void addFirst(Call call) {
    waiting(call).of(call).addFirst(call);
  }

  /** Removes a waiting call; false if it does not wait. */
  boolean remove(Call call) {
    return waiting(call).remove(call);
  }

  /** Removes all waiting calls. */
  void clear() {
    answering.hosts.clear();
    others.hosts.clear();
  }

  /**
   * Removes the next call.
   *
   * @param mayBeUnanswered whether it may be one whose peer did not answer a connection attempt
   * @return null if none may start
   */
  @Nullable Call take(boolean mayBeUnanswered) {
    if (!answering.hosts.isEmpty()) {
      return answering.take();
    }
    return mayBeUnanswered && !others.hosts.isEmpty() ? others.take() : null;
  }

  private WaitingCalls waiting(Call call) {
    return call.answersProbe ? answering : others;
  }

  /** By host, and for each host by robot; the next ones first. */
  private static final class WaitingCalls {
    private final Map<String, Map<String, Deque<Call>>> hosts = new LinkedHashMap<>();

    Deque<Call> of(Call call) {
      return hosts
          .computeIfAbsent(call.host(), unused -> new LinkedHashMap<>())
          .computeIfAbsent(call.robot, unused -> new ArrayDeque<>());
    }

    /** Removes the next one. There is one. */
    Call take() {
      Map.Entry<String, Map<String, Deque<Call>>> host = hosts.entrySet().iterator().next();
      Call call = host.getValue().values().iterator().next().getFirst();
      boolean unused = remove(call);
      @Nullable Map<String, Deque<Call>> robots = hosts.remove(host.getKey());
      if (robots != null) {
        @Nullable Deque<Call> calls = robots.remove(call.robot);
        if (calls != null) {
          robots.put(call.robot, calls); // the robot's next call is behind those of other robots
        }
        hosts.put(call.host(), robots);
      }
      return call;
    }

    /** Whether it waited here. */
    boolean remove(Call call) {
      @Nullable Map<String, Deque<Call>> robots = hosts.get(call.host());
      @Nullable Deque<Call> calls = robots == null ? null : robots.get(call.robot);
      if (robots == null || calls == null || !calls.remove(call)) {
        return false;
      }
      if (calls.isEmpty()) {
        robots.remove(call.robot);
      }
      if (robots.isEmpty()) {
        hosts.remove(call.host());
      }
      return true;
    }
  }
}
