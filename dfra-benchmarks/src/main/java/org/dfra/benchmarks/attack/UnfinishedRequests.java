package org.dfra.benchmarks.attack;

import java.lang.reflect.Method;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.remote.effector.RemoteDriveEffector;

/**
 * Opens thousands of requests over few connections and finishes none. They call a public method:
 * the server refuses a request for an administrative method before it is complete.
 */
final class UnfinishedRequests extends AttackTask {

  private static final int CONNECTIONS = 25;
  private static final int REQUESTS = 120; // per connection; JERI allows 128
  private static final long AGAIN_MILLIS = 20;
  private static final Duration LEASE = Duration.ofSeconds(5); // never granted

  private final List<RemoteDriveEffector> connections = new ArrayList<>();
  private final Deque<RawCall> open = new ArrayDeque<>();
  private byte[] bytes = {};

  /** Called by {@code TaskMain} by reflection. */
  public UnfinishedRequests() {}

  @Override
  protected void prepare(Target target) throws Exception {
    Method method = RemoteModule.class.getMethod("acquireLease", Duration.class);
    bytes = CallBytes.of(method, LEASE);
    RemoteDriveEffector drive = target.remoteDrive();
    for (int i = 0; i < CONNECTIONS; i++) {
      connections.add(SourceBoundProxies.of(drive, target.sockets().unshared()));
    }
  }

  /** Opens the maximum number of requests, and then replaces the oldest as fast as possible. */
  @Override
  protected void attack(Target target) {
    for (RemoteDriveEffector each : connections) {
      if (isStopping()) {
        return;
      }
      if (open.size() >= CONNECTIONS * REQUESTS) {
        open.remove().close();
        pause(AGAIN_MILLIS);
      }
      RawCall call = attempt(() -> RawCall.to(each).send(bytes, bytes.length - 1));
      if (call == null) {
        pause(AGAIN_MILLIS);
      } else {
        open.add(call);
      }
    }
  }
}
