package org.dfra.river.access;

import java.rmi.server.ServerNotActiveException;
import java.util.Optional;
import net.jini.export.ServerContext;
import org.dfra.security.AccessRequest;
import org.jspecify.annotations.Nullable;

/** The remote call that runs on a thread, as a guard has permitted it. */
public final class PermittedCall {

  private PermittedCall() {}

  /** The call on this thread; empty if there is none, or if no guard has decided about it. */
  public static Optional<AccessRequest> current() {
    try {
      @Nullable Object request = ServerContext.getServerContextElement(AccessRequest.class);
      return Optional.ofNullable((AccessRequest) request);
    } catch (ServerNotActiveException e) {
      return Optional.empty();
    }
  }
}
