package org.dfra.river.identity;

import java.math.BigInteger;
import java.rmi.server.ServerNotActiveException;
import java.util.List;
import java.util.Optional;
import javax.security.auth.Subject;
import net.jini.export.ServerContext;
import org.dfra.river.access.CredentialPeer;
import org.dfra.security.Caller;

/** The authenticated process at the other end of an encrypted connection. Thread-safe. */
public interface ChannelPeer extends CredentialPeer {

  /** What is proved of it now: a revoked or expired certificate proves less than it did. */
  Caller caller();

  /** Its principals; empty if it has no certificate, or a revoked one. Read-only. */
  Subject subject();

  /**
   * The number of its certificate, also of a revoked one, and of that of the member on whose behalf
   * it calls. Empty if it has none, or if it is on this computer and has the identity of this end:
   * a revoked robot still works for itself.
   */
  List<BigInteger> certificateNumbers();

  /**
   * Whether the connection, and what the peer was granted, has to end: its certificate was revoked
   * or, if it is the server, has expired; or the delegation with which it calls no longer counts.
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
