package org.dfra.benchmarks.attack;

import java.lang.reflect.Method;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Objects;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.remote.effector.RemoteDriveEffector;
import org.jspecify.annotations.Nullable;

/**
 * Opens thousands of requests and finishes none. They call a public method: the server refuses a
 * request for an administrative method before it is complete.
 */
final class UnfinishedRequests extends AttackTask {

  private static final int REQUESTS = 3000; // each on a connection of its own
  private static final long AGAIN_MILLIS = 20;
  private static final Duration LEASE = Duration.ofSeconds(5); // never granted

  private @Nullable RemoteDriveEffector drive;
  private final Deque<RawCall> open = new ArrayDeque<>();
  private byte[] bytes = {};

  /** Called by {@code TaskMain} by reflection. */
  public UnfinishedRequests() {}

  @Override
  protected void prepare(Target target) throws Exception {
    Method method = RemoteModule.class.getMethod("acquireLease", Duration.class);
    bytes = CallBytes.of(method, LEASE);
    drive = SourceBoundProxies.of(target.remoteDrive(), target.sockets());
  }

  /** Opens the maximum number of requests, and then replaces the oldest as fast as possible. */
  @Override
  protected void attack(Target target) {
    if (open.size() >= REQUESTS) {
      open.remove().close();
    }
    RawCall call =
        attempt(() -> RawCall.to(Objects.requireNonNull(drive)).send(bytes, bytes.length - 1));
    if (call == null) {
      pause(AGAIN_MILLIS);
    } else {
      open.add(call);
    }
  }
}
