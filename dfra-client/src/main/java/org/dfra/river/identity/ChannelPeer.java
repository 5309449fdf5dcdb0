package org.dfra.river.identity;

import javax.security.auth.Subject;
import org.dfra.river.access.CredentialPeer;
import org.dfra.security.Caller;

/** The authenticated process at the other end of an encrypted connection. Thread-safe. */
public interface ChannelPeer extends CredentialPeer {

  /** What is proved of it now: a revoked or expired certificate proves less than it did. */
  Caller caller();

  /** Its principals; empty if it has no certificate, or a revoked one. Read-only. */
  Subject subject();

  /**
   * Whether the connection, and what the peer was granted, has to end: its certificate was revoked
   * or, if it is the server, has expired; or the delegation with which it calls no longer counts.
   */
  boolean isRevoked();
}
