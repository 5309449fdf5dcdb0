package org.dfra.river.identity;

import java.math.BigInteger;
import java.rmi.server.ServerNotActiveException;
import java.util.Optional;
import javax.security.auth.Subject;
import net.jini.export.ServerContext;
import org.dfra.security.Caller;

/** The authenticated process at the other end of an encrypted connection. Thread-safe. */
public interface ChannelPeer {

  /** What is proved of it now: a revoked or expired certificate proves less than it did. */
  Caller caller();

  /** Its principals; empty if it has no certificate, or a revoked one. Read-only. */
  Subject subject();

  /**
   * The number of its certificate, also of a revoked one. Empty if it has none, or if it is on this
   * computer and has the identity of this end: a revoked robot still works for itself.
   */
  Optional<BigInteger> certificateNumber();

  /**
   * Whether the connection has to be closed: the peer's certificate was revoked, or, if it is the
   * server, has expired.
   */
  boolean isRevoked();

  /** The peer that makes the remote call on this thread; empty if its connection is open. */
  static Optional<ChannelPeer> ofCurrentCall() {
    try {
      return Optional.ofNullable(
          (ChannelPeer) ServerContext.getServerContextElement(ChannelPeer.class));
    } catch (ServerNotActiveException e) {
      return Optional.empty();
    }
  }
}
