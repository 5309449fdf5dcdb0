package org.dfra.river.server.behavior;

import java.math.BigInteger;
import java.rmi.RemoteException;
import java.util.List;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.river.access.PermittedCall;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.lease.LeaseHolder;
import org.dfra.river.server.behavior.GoalGiver.GoalCall;
import org.dfra.security.Caller;
import org.dfra.security.Permissions;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Who has given a behaviour its goal, or resumed it last. If the team's authority revokes that
 * member, or a new policy does not permit it to do that, the goal is paused and the robot stands,
 * until another member resumes or cancels it. This holds for a goal of an earlier process too.
 *
 * <p>It stores the number of the member's certificate, and of the one on whose behalf it has
 * called. What the robot's own processes have given has no number: a revoked robot still works for
 * itself. It also stores the call, and the version of the policy that has permitted it last: a
 * process that is restarted does not decide again by the same policy, since it may not know the
 * robot's position yet. Thread-safe.
 */
final class GoalRequester implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(GoalRequester.class);

  private final String path;
  private final String object;
  private final BehaviorImpl<?> behavior;
  private final Class<?> type;
  private final @Nullable ChannelIdentity identity;
  private final Permissions permissions;
  private final Runnable notWatching;

  /** A call that sets the robot in motion. */
  @FunctionalInterface
  interface Request<T extends @Nullable Object> {

    /** Calls. */
    T call() throws RemoteException;
  }

  /**
   * Watches the list of revoked certificates and the policy of the current identity until it is
   * closed.
   *
   * @param path the behaviour's path, {@code robot/name}
   * @param behavior is started
   * @param type class of its server, which policies name by its interfaces
   */
  GoalRequester(String path, BehaviorImpl<?> behavior, Class<?> type) {
    this.path = path;
    this.object = path.substring(path.indexOf('/') + 1);
    this.behavior = behavior;
    this.type = type;
    this.identity = CurrentIdentity.get();
    this.permissions = LeaseHolder.currentPermissions();
    this.notWatching = CurrentIdentity.onLostRights(this::rightsChanged);
    review(false); // what happened while the process was down
  }

  /**
   * Makes a request of the client of the call that runs on this thread. Who it is is stored before
   * the robot moves; if the request is refused, the former one stays.
   */
  synchronized <T extends @Nullable Object> T by(Request<T> request) throws RemoteException {
    String former = behavior.requester();
    List<BigInteger> numbers =
        ChannelPeer.ofCurrentCall().map(ChannelPeer::certificateNumbers).orElse(List.of());
    behavior.storeRequester(
        GoalGiver.of(numbers, PermittedCall.current(), permissions.version()).text());
    boolean isAccepted = false;
    T result;
    try {
      result = request.call();
      isAccepted = true;
    } finally {
      if (!isAccepted) {
        behavior.storeRequester(former);
      }
    }
    review(true); // since its call was permitted
    return result;
  }

  /**
   * As {@link #by}, for a program that resumes a goal. The robot's own programs do it for the one
   * who gave the goal, who stays the one that must be permitted to.
   */
  <T extends @Nullable Object> T byProgram(Request<T> request) throws RemoteException {
    boolean isOwn =
        PermittedCall.current()
            .map(each -> each.caller().standing() == Caller.Standing.OWN)
            .orElse(false);
    if (!isOwn) {
      return by(request);
    }
    T result = request.call();
    review(false);
    return result;
  }

  /** Who brings a list or a policy does not wait for a control cycle to end. */
  private void rightsChanged() {
    GoalGiver giver = giver(behavior.requester());
    @Nullable GoalCall call = giver.call();
    if (isRevoked(giver) || (call != null && call.policy() != permissions.version())) {
      Thread reviewing = new Thread(() -> review(false), "dfra-rights " + path);
      reviewing.setDaemon(true);
      reviewing.start();
    }
  }

  /**
   * Pauses the goal if the one who gave it may no longer.
   *
   * @param isAlways whether the call is decided again even if the policy is the one that has
   *     permitted it
   */
  private void review(boolean isAlways) {
    String stored = behavior.requester();
    GoalGiver giver = giver(stored);
    if (isRevoked(giver)) { // without effect if no goal is under way
      behavior.pauseBecause("the certificate of the one who gave the goal was revoked");
      return;
    }
    @Nullable GoalCall call = giver.call();
    long version = permissions.version();
    if (call == null || (call.policy() == version && !isAlways)) {
      return;
    }
    if (isStillPermitted(call)) {
      storeReviewed(stored, giver.reviewedBy(version));
    } else {
      behavior.pauseBecause(
          "policy " + version + " does not permit " + call.who() + " what started it");
    }
  }

  private boolean isStillPermitted(GoalCall call) {
    return identity == null
        || permissions.isStillPermitted(call.request(identity.robot(), object, type));
  }

  /** Unless somebody else has given or resumed a goal meanwhile. */
  private synchronized void storeReviewed(String stored, GoalGiver reviewed) {
    if (behavior.requester().equals(stored)) {
      behavior.storeRequester(reviewed.text());
    }
  }

  private boolean isRevoked(GoalGiver giver) {
    return identity != null && giver.certificates().stream().anyMatch(identity::isRevoked);
  }

  private GoalGiver giver(String stored) {
    try {
      return GoalGiver.parse(stored);
    } catch (IllegalArgumentException e) {
      LOG.error("{}: it is not known who gave its goal: {}", path, e.getMessage());
      return new GoalGiver(List.of(), null);
    }
  }

  @Override
  public void close() {
    notWatching.run();
  }
}
