package org.dfra.river.access;

import net.jini.jeri.ServerCapabilities;
import org.dfra.security.Guard;
import org.jspecify.annotations.Nullable;

/** A server endpoint that authenticates its callers, and has a guard for them. */
public interface GuardedEndpoint {

  /** The guard of what is exported on it; null if it authenticates nobody. */
  @Nullable Guard guard();

  /** The robot whose identity it has; empty for persons and programs. */
  String robot();

  /**
   * Such an endpoint.
   *
   * @param capabilities the endpoint, as a dispatcher gets it
   * @return null if it authenticates nobody
   */
  static @Nullable GuardedEndpoint of(ServerCapabilities capabilities) {
    return capabilities instanceof GuardedEndpoint guarded && guarded.guard() != null
        ? guarded
        : null;
  }
}
