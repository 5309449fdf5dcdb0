package org.dfra.river.server.behavior;

import java.math.BigInteger;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.dfra.river.identity.CurrentIdentity;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Who has given a behaviour its goal, or resumed it last. If the team's authority revokes that
 * member, the goal is paused and the robot stands, until another member resumes or cancels it. This
 * holds for a goal of an earlier process too.
 *
 * <p>It stores the number of the member's certificate, and of the one on whose behalf it has
 * called. What the robot's own processes have given has no requester: a revoked robot still works
 * for itself. Thread-safe.
 */
final class GoalRequester implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(GoalRequester.class);

  private static final int RADIX = 16;

  private final String path;
  private final BehaviorImpl<?> behavior;
  private final @Nullable ChannelIdentity identity;
  private final Runnable notRevoking;

  /** A call that sets the robot in motion. */
  @FunctionalInterface
  interface Request<T extends @Nullable Object> {

    /** Calls. */
    T call() throws RemoteException;
  }

  /**
   * Watches the list of revoked certificates of the current identity until it is closed.
   *
   * @param path the behaviour's path, for messages
   * @param behavior is started
   */
  GoalRequester(String path, BehaviorImpl<?> behavior) {
    this.path = path;
    this.behavior = behavior;
    this.identity = CurrentIdentity.get();
    this.notRevoking = CurrentIdentity.onRevocation(this::pauseInBackground);
    pauseIfRevoked(); // while the process was down
  }

  /**
   * Makes a request of the client of the call that runs on this thread. Its number is stored before
   * the robot moves; if the request is refused, the former one stays.
   */
  synchronized <T extends @Nullable Object> T by(Request<T> request) throws RemoteException {
    String former = behavior.requester();
    behavior.storeRequester(
        ChannelPeer.ofCurrentCall().map(ChannelPeer::certificateNumbers).orElse(List.of()).stream()
            .map(number -> number.toString(RADIX))
            .collect(Collectors.joining(" ")));
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
    pauseIfRevoked(); // since its call was permitted
    return result;
  }

  /** Who brings the list does not wait for a control cycle to end. */
  private void pauseInBackground() {
    if (isRevoked()) {
      Thread pausing = new Thread(this::pauseIfRevoked, "dfra-revoked " + path);
      pausing.setDaemon(true);
      pausing.start();
    }
  }

  private void pauseIfRevoked() {
    if (isRevoked()) { // without effect if no goal is under way
      behavior.pauseBecause("the certificate of the one who gave the goal was revoked");
    }
  }

  private boolean isRevoked() {
    return identity != null && numbers().stream().anyMatch(identity::isRevoked);
  }

  private List<BigInteger> numbers() {
    List<BigInteger> numbers = new ArrayList<>();
    for (String each : behavior.requester().split(" ", -1)) {
      try {
        if (!each.isEmpty()) {
          numbers.add(new BigInteger(each, RADIX));
        }
      } catch (NumberFormatException e) {
        LOG.error("{}: it is not known who gave its goal: {}", path, e.getMessage());
      }
    }
    return numbers;
  }

  @Override
  public void close() {
    notRevoking.run();
  }
}
